// The page's state, in one place. Modules read it, change it through `set`, and hear of changes.

export function createStore(initial) {
  const state = { ...initial };
  const listeners = new Set();
  return {
    get: () => state,
    /** Merges `changes` and tells every listener which keys really changed. */
    set(changes) {
      const changed = new Set();
      for (const [key, value] of Object.entries(changes)) {
        if (!Object.is(state[key], value)) {
          state[key] = value;
          changed.add(key);
        }
      }
      if (changed.size > 0) for (const listener of listeners) listener(state, changed);
    },
    subscribe(listener) {
      listeners.add(listener);
    },
  };
}
