//! The program as a user meets it: run as a process of its own, in a folder of its own.

mod bad_input;
mod color;
mod corpus;
mod folder;
