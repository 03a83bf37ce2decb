(** States and transition labels as JSON (see [specs/schema]). Lengths are in the model's units, velocities
    in those per unit of time, positions in the world. *)

open Scc_calculus
open Scc_semantics

val label : Model.t -> Transition.label -> Json.t
(** [{"kind", "text", …}]: what the label is, its text, and its parts by name. *)

val state : Model.t -> State.t -> Json.t
(** The state in full. *)

val bond : Model.t -> State.bond -> (string * Json.t) list
(** The members [name] and [ends]. *)

val behaviour : Model.t -> leaf:int -> Behaviour.aged -> string

val phase : State.phase -> string
(** ["moving"], ["due"] or ["steered"]. *)

val kind : Transition.label -> string
(** ["time"], ["bind"], ["close"], ["bounce"], ["absorb"], ["weak"] or ["strong"]. *)

val quaternion : Scc_exact.Quaternion.t -> Json.t
(** An array of four integers as texts: w, x, y, z. *)

val origin : Model.t -> Behaviour.aged -> Json.t
(** The name of the definition that it comes from; [null] without one. *)
