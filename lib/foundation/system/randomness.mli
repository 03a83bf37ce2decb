(** Bytes that no one can foresee, for secrets. *)

val bytes : int -> (string, string) result
(** [bytes n] is [n] random bytes, at most 256, from the kernel, or from [/dev/urandom] where the kernel has no
    call for them. The error says why there are none. *)
