(** From bodies that are in order to the model and its declared state. *)

open Scc_base
open Scc_calculus

val check_overlaps : Context.t -> Bodies.t -> Composition.t -> unit
(** No two parts of the network interpenetrate (SC0403): of bodies whose places depend on no range. *)

val uncertain : Bodies.t -> Composition.t -> Ranges.t -> Uncertain.t option
(** What depends on the ranges; [None] where there are none. *)

val leaves : Bodies.t -> Composition.t -> Model.leaf array
(** No body of the network has faults (a bug otherwise). *)

val spinning : Bodies.t -> Composition.t -> (string * Span.t) option
(** The first body of the network that is given a spin, by its name, and where it is declared. *)

val state : Bodies.t -> Composition.t -> Joints.t list -> Behaviour.t array -> Model.t -> State.t
(** The behaviours are by index in the model. No split clock is set yet; a steered network is due to be
    steered. *)
