(** Labels of transitions as bytes and back, as {!State_codec} writes what occurs in them. *)

open Scc_semantics

val put : State_codec.t -> Buffer.t -> Transition.label -> unit

val read : State_codec.t -> Packed.source -> Transition.label
(** Raises {!Packed.Malformed}. *)
