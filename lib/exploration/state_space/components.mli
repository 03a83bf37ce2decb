(** Tables that give numbers to the parts of states and to labels, in the order in which they come up. *)

open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics

val hash_label : Transition.label -> int
(** A hash that agrees with {!Scc_semantics.Transition.equal_label}. *)

(** The draws and lots of one instant as one transition (rule JoinedDraws): the chance of all of them together,
    and the number of transitions that it stands for. *)
type joint = { chance : Rat.t; transitions : int }

(** A label; one of an urgent transition, with the probability that chance gives it (rule Ties); or joined draws.
*)
type label = One of Transition.label | Tied of Transition.label * Rat.t | Joint of joint

module Vectors : module type of Numbering.Make (Vec)

module Forms : module type of Numbering.Make (struct
    type t = State.process

    let equal = State.equal_process
    let hash = State.hash_process
  end)

module Label_key : Hashtbl.HashedType with type t = label
module Labels : module type of Numbering.Make (Label_key)

module Step_key : Hashtbl.HashedType with type t = State.step
module Steps : module type of Numbering.Make (Step_key)
