(** The places of {!Decisions} for "f until g" within a window of time that ends, or up to a time, by layers. A
    layer is the places that are entered at one time. Time passes from a layer to later ones only. Within a layer,
    nodes have ranks such that edges lead to smaller ones. So values can be computed from the last layer back
    ({!Layered}).

    It works if no run comes back to a node in no time. Otherwise a layer would be a system of equations. *)

open Scc_data
open Scc_exact
open Scc_chance

(** A choice of a place. For each branch [target] is a node, or {!at_goal} or {!at_fail}, and [delay] the number of
    a delay: 0 for no time. *)
type choice = { weights : Arithmetic.weights; target : int array; delay : int array }

val at_goal : int
(** The target of a branch that leads to [Goal]. *)

val at_fail : int
(** The target of a branch that leads to [Fail]. *)

val end_number : int -> int
(** [end_number target] is k where the target of a branch is an end with the reward [(rewards t).(k)]. Such targets
    are less than {!at_fail}. *)

type layer

type t
(** The layers of the places that can be reached from some starts. *)

exception Too_many of Rat.t
(** There are more layers than allowed. The first ones, as many as allowed, are of times up to this. *)

val too_many : most:int -> over:Rat.t -> Rat.t -> string
(** [too_many ~most ~over time] says that there are too many layers up to [time], where {!Too_many} had [over]. *)

val until : ?most:int -> Decisions.question -> Decisions.window -> Decisions.next list -> t option
(** [until ?most q w starts] is the layers of all places of the question [q] that can be reached from the
    starts. It is [None] if the window has no end, or if some of these runs may come back to a node in no time.
    It may raise {!Too_many} where there are more than [most] layers (default: no limit). *)

val means :
  ?most:int -> Timed_graph.t -> Timed_formula.side ->
  choices:(Decisions.place -> Decisions.branch list list) -> Rat.t -> Decisions.next list -> t option
(** [means ?most graph side ~choices time starts] is the layers of all places up to [time]. Each run ends by a
    branch to [Goal], with the reward of that branch, or by one to [Fail], with none. The choices of a node may
    depend on the time only where its flow does not end before [time]. It is [None] if some run may come back to a
    node in no time. It may raise {!Too_many} as {!until} does. *)

val side : t -> Timed_formula.side
(** [side t] is whether choices make values least or greatest. *)

val choices : t -> Decisions.place -> Decisions.branch list list
(** [choices t p] is the choices of a place, as given to {!until} or {!means}. *)

val rewards : t -> Rat.t array
(** [rewards t] is the rewards of all ends, each once, by their numbers ({!end_number}). *)

val starts : t -> Decisions.next list
(** [starts t] is the starts given to {!until} or {!means}. *)

val is_free : t -> bool
(** [is_free t] is true if some place has several choices. *)

val base : t -> Z.t
(** [base t] is a common multiple of the sums of the weights of all choices. *)

val all : t -> layer array
(** [all t] is the layers in the order of their times. The array must not be changed. *)

val layer_of : t -> Rat.t -> layer
(** [layer_of t time] is the layer of this time. There is one (a bug otherwise). *)

val time : layer -> Rat.t
(** [time layer] is when its places are entered. *)

val number : layer -> int
(** [number layer] is its index in {!all}. *)

val first_source : layer -> int
(** [first_source layer] is the number of the first layer of which a branch leads to it, or its own. *)

val ranks : layer -> Int_array.t
(** [ranks layer] is the ranks of the nodes of its places, increasing. The array must not be changed. *)

val later : t -> layer -> int -> layer
(** [later t layer delay] is the layer to which a branch with the delay of this number leads. *)

val choices_of : t -> layer -> int -> choice array
(** [choices_of t layer s] is the choices of node [s] in this layer, in the order of {!Decisions.choices}. *)

val index : layer -> int -> int
(** [index layer rank] is the index of a rank in {!ranks}. It is there. *)

val rank_of : t -> int -> int
(** [rank_of t target] is the rank of a node, and [target] itself for {!at_goal} and {!at_fail}. *)

val node_of : t -> int -> int
(** [node_of t rank] is the node with this rank. *)

val count : t -> int
(** [count t] is the number of ranks: they are from 0 on. *)

val arrivals : Decisions.question -> Decisions.window -> t -> Timeline.moment list
(** [arrivals q w t] is the times at which some run from a start may meet g, increasing, each once, where [t] is of
    [until q w]. Times are elapsed times, as those of places. *)
