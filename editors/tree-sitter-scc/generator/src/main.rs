//! Makes the parser of a grammar for tree-sitter: `generator FOLDER` writes FOLDER/src from FOLDER/grammar.js, by node.

use tree_sitter_generate::{generate_parser_in_directory, OptLevel};

// What Neovim and Emacs of Debian 12 and 13 load.
const ABI: usize = 14;

fn main() {
    let folder = std::env::args().nth(1).expect("generator FOLDER");
    let grammar = format!("{folder}/grammar.js");
    let made = generate_parser_in_directory(
        folder, None::<&str>, Some(grammar), ABI, None, Some("node"), true, OptLevel::default());
    if let Err(error) = made {
        eprintln!("{error}");
        std::process::exit(1);
    }
}
