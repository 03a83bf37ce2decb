(** The draws and lots of one instant as one transition (rule JoinedDraws): their joint distribution, without the
    states between them. *)

open Scc_exact
open Scc_semantics

(** A state after draws: its tuple, the chance of the draws that lead to it, and the fewest of these. *)
type outcome = { tuple : int array; chance : Rat.t; transitions : int }

module Tuple_table : Hashtbl.S with type key = int array
(** Tables by tuples. *)

val most : int
(** The greatest number of joint outcomes of one state: 2{^16}, those of eight bodies with four velocities each. *)

val merged : outcome list -> outcome list
(** [merged outcomes] is the outcomes with each tuple once, in the order in which they come up, with the sum of its
    chances and the fewest transitions. *)

val through :
  (int array -> (outcome list option, 'fault) result) ->
  outcome list ->
  (outcome list option, 'fault) result
(** [through leave outcomes] is the outcomes after all draws that follow: each tuple once, with the sum of its
    chances and the fewest transitions. They are merged after each round of draws. [leave tuple] is the outcomes of
    a state that draws, and [None] for any other state. The result is [None] if a round has more than {!most}
    outcomes. The fault is the first one. *)

val velocities : Semantics.t -> Catalogue.t -> int array -> (outcome list option, Transition.fault) result
(** [velocities c catalogue tuple] is the outcomes of all draws of velocities in a state in which nothing turns, no
    lots are pending, and some process waits to draw. They are in the order of the draws. The outcome of each
    process depends on its own draw alone, so that one step of the kernel is made for each process and velocity.
    The result is [None] if there are more than {!most} outcomes. *)

val joins : Semantics.t -> Scc_calculus.State.t -> bool
(** [joins semantics initial] is true if the leaves of [initial] that move, each by itself, have at most {!most}
    joint outcomes when all of them draw. Two outcomes are counted for a leaf that does not draw, for the lots of
    bonds. Then draws and lots are joined in each state of the network that begins with [initial]. *)
