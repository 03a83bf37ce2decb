(** What was done to a mesh on request before anything else, in the reports on it. *)

val field : (string * string) list -> (string * Json.t) list
(** From the name of each option, with a line on what it did, in this order; no field if there were none. *)
