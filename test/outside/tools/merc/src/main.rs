//! Decides with merc whether pairs of graphs are equivalent: what `scc compare` is held against.
//!
//! Reads lines `RELATION FIRST.aut SECOND.aut` (strong, branching or weak) from standard input and prints
//! `equivalent` or `different` for each. The silent action is `tau`.

use std::fs::File;
use std::io::{self, BufRead, Write};
use std::process::ExitCode;

use merc_lts::{LabelledTransitionSystem, read_mcrl2_aut};
use merc_reduction::{Equivalence, compare_lts};
use merc_utilities::Timing;

fn relation(name: &str) -> Result<Equivalence, String> {
    match name {
        "strong" => Ok(Equivalence::StrongBisim),
        "branching" => Ok(Equivalence::BranchingBisim),
        "weak" => Ok(Equivalence::WeakBisim),
        _ => Err(format!("no relation {name}")),
    }
}

fn graph(path: &str) -> Result<LabelledTransitionSystem<String>, String> {
    let file = File::open(path).map_err(|e| format!("{path}: {e}"))?;
    read_mcrl2_aut(file).map_err(|e| format!("{path}: {e}"))
}

fn decide(line: &str) -> Result<bool, String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    match words[..] {
        [name, first, second] => {
            let mut timing = Timing::new();
            Ok(compare_lts(relation(name)?, graph(first)?, graph(second)?, false, &mut timing))
        }
        _ => Err(format!("cannot read: {line}")),
    }
}

fn main() -> ExitCode {
    for line in io::stdin().lock().lines() {
        let answer = line.map_err(|e| e.to_string()).and_then(|l| decide(&l));
        match answer {
            Ok(same) => println!("{}", if same { "equivalent" } else { "different" }),
            Err(message) => {
                eprintln!("merc-compare: {message}");
                return ExitCode::FAILURE;
            }
        }
        let _ = io::stdout().flush();
    }
    ExitCode::SUCCESS
}
