(** Labels of transitions as bytes and back. {!State_codec} has the bytes of the bonds in them. *)

open Scc_semantics

val put : State_codec.t -> Buffer.t -> Transition.label -> unit
(** Appends the bytes of a label to the buffer. *)

val read : State_codec.t -> Packed.source -> Transition.label
(** Reads a label and moves behind it. Raises {!Packed.Malformed} for other bytes. *)
