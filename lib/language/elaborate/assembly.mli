(** From bodies without faults to the model and its declared state. *)

open Scc_base
open Scc_calculus

val check_overlaps : Context.t -> Bodies.t -> Composition.t -> unit
(** Checks that no two parts of the network interpenetrate (SC0403). Bodies whose places depend on ranges of
    parameters are left out. At most 10 pairs are reported. *)

val uncertain : Bodies.t -> Composition.t -> Ranges.t -> Uncertain.t option
(** [uncertain bodies composition ranges] is all that depends on the ranges, or [None] if there are no
    ranges. *)

val leaves : Bodies.t -> Composition.t -> Model.leaf array
(** The leaves of the model, in the order of declaration. A body of the network with faults is a bug. *)

val spinning : Bodies.t -> Composition.t -> (string * Span.t) option
(** The first body of the network that has a spin, or to which a law gives one: a clause that says so, and the
    place of the body or of the law. *)

val state : Bodies.t -> Composition.t -> Joints.t list -> Behaviour.t array -> Model.t -> State.t
(** The declared state. The behaviours are by index in the model. No split clock is set; the movement step of a
    steered network is due. *)
