(** Floats as texts that read back as the same floats: the same bytes on every machine. *)

val shortest : float -> string
(** [shortest x] is the shortest decimal of 15, 16 or 17 digits that reads back as the finite float [x]: [0.1],
    [3.0], [1e+22]. It is a number of JSON. *)
