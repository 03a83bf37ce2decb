(** Rule Time on sets of states: the delays and split clocks that a zone waits for, and the zone when time has
    passed. All times are forms over the variables of the zone. *)

open Scc_polyhedra
open Scc_calculus

val length : Model.t -> Behaviour.t -> Linear.t
(** [length m b] is the length of the delay [b], as a form over the parameters of [m]. Any other prefix is a
    bug. *)

val lengths : Model.t -> State.leaf -> Linear.t list
(** [lengths m l] is the length of each delay that waits in [l], as a form over the parameters of [m]. *)

val left : Zone.t -> int -> Linear.t -> Linear.t
(** [left z leaf length] is the time until a delay of this length expires, which waits in the leaf. *)

val to_split_instant : Model.t -> Zone.t -> State.process -> (int * Linear.t) option
(** [to_split_instant m z p] is the first leaf of [p] and the time until its next split instant; [None] if its
    split clock does not run. *)

val to_split_instants : Model.t -> Zone.t -> (int * Linear.t) list
(** [to_split_instants m z] has {!to_split_instant} of each process whose split clock runs. *)

val all_left : Model.t -> Zone.t -> Linear.t list
(** The times until each delay that waits expires, then those until each next split instant. *)

val may_split : Zone.t -> bool
(** [may_split z] is true if a weak split is enabled in some process. *)

val splits_at_any_time : Model.t -> Zone.t -> bool
(** [splits_at_any_time m z] is true if some process may release a bond at any time
    ({!Scc_semantics.Process.splits_at_any_time}). *)

val after : Model.t -> Zone.t -> Linear.t -> Zone.t
(** [after m z time] are the states of [z] when this time has passed, without an event on the way. Delays and split
    clocks that are over then have their whole length: no delay has expired, and no clock begins anew.
    Likewise the movement step is not over, and no split instant of the network has come. *)
