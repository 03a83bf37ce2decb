(** Changes made to a mesh on request before anything else, in the reports on it. *)

open Scc_json

val field : ((string * string) list, unit) Json_format.members
(** A field with the name of each option and a line on its effect, in this order. No field if there are none. *)
