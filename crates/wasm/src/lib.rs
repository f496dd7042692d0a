//! Bindings of bladefan for the browser and Node.
