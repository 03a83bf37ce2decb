(** What a command says of estimates. *)

open Scc_session

type t = {
  origin : Origin.t;
  aim : Estimation.aim;
  seed : int64;
  answers : Estimation.answer list;
  left_out : (string * string) list;  (** checks, and why they are not estimated *)
  interrupted : bool;
}

val word : Estimation.verdict -> string
(** ["estimated"], ["estimated to hold"], ["estimated to be violated"], ["undecided"]. *)

val line : Estimation.answer -> confidence:Scc_exact.Rat.t -> string
(** What follows the name and the verdict: the interval, rounded outwards, and how many runs there were. *)

val json : t -> exit:Exit_code.t -> Scc_exchange.Json.t
(** The format [specs/schema/estimate.schema.json]; all numbers are exact. *)
