(** Coverage as text. *)

open Scc_verify

val lines : Console.t -> Explored.t -> Coverage.t -> string
(** A line with the counts, the items that never fired or were never reached or used, and how often each rule
    was used. *)
