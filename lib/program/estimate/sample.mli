(** One run of many, and what it says of each question. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** What is done where several transitions are possible and none of them is drawn. *)
type free =
  | Apart  (** nothing: what is not known by then stays so, and counts for the worst and for the best *)
  | Evenly  (** one of them is taken, each as likely *)

type plan = {
  semantics : Semantics.t;
  declared : State.t;
  paths : Path.t list;
  free : free;
  steps : int;  (** transitions at most *)
  until : Rat.t option;  (** model time at most; the horizon of all questions ends a run as well *)
}

type outcome =
  | Truth of bool
  | Number of Rat.t
  | Never  (** it never comes to where the number would be known: infinite *)
  | Free  (** it depends on a choice that nothing draws *)
  | Too_long  (** it did not come so far *)
  | No_value of string

val run : plan -> seed:int64 -> int -> outcome list * bool
(** Of the run of this number, which has the seed {!Scc_simulate.Simulation.seed_of}: of each path in order; and
    whether a choice that nothing draws was taken, evenly. *)
