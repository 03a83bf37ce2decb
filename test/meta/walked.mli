(** A test of {!Tree.files}. *)

val sources_only : unit -> unit
(** Fails unless a folder that is made for it is listed with its sources alone, while a file vanishes. *)
