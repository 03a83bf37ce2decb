(** Coverage for a person. *)

open Scc_verify

val lines : Console.t -> Explored.t -> Coverage.t -> string
(** A line with the counts, what never fired or was never reached or used, and how often each rule was used. *)
