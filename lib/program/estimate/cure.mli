(** Where many runs may tell what an exploration did not. *)

open Scc_calculus
open Scc_verify

val of_outcome : Model.t -> Verdict.outcome -> string option
(** Of a probability or a mean for which {!Estimation} has intervals, and which a bound on states, seconds or
    memory, or an interruption, kept from being known: what to ask instead. [None] also where a probability is
    compared with 0 or 1, which samples decide on one side only; and over zones. *)
