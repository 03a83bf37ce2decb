(** Moments as bytes. *)

open Scc_ctl
open Scc_codec

val put : Buffer.t -> Timeline.moment -> unit
(** Appends a moment. *)

val read : Packed.source -> Timeline.moment
(** Reads the bytes of {!put}. Raises [Packed.Malformed]. *)
