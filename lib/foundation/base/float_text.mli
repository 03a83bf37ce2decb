(** Floats as texts that read back as the same floats: the same bytes on every machine. *)

val shortest : float -> string
(** The shortest of 15, 16 and 17 digits, of a finite float: [0.1], [3.0], [1e+22]. It is a number of JSON. *)
