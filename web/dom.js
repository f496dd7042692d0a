/** The element of this id. */
export const at = (id) => document.getElementById(id);
