// What `cargo xtask dist` writes into the worker; see `crates/xtask/src/version.rs`.

/** The folder of this version, below that of the page. */
declare const VERSION: string;

/** Every file of it, by its path from the page's folder, with what `fetch` checks its content against. */
declare const FILES: Record<string, string>;
