(** Names for tools that take letters, digits and underscores only. *)

type t
(** The names in use, with their texts. *)

val make : reserved:string list -> t
(** No names yet. Those in [reserved] are never given. *)

val name : t -> string -> string
(** The name of a text: always the same, different for each text, and none of the reserved ones. It begins with
    a letter and has at most 64 characters. Names depend on the order in which texts are given.

    The name resembles the text: [x(p) <= 3] is [x_p_le_3], and [time(1/2)] is [time_1_over_2]. If two texts
    would have one name, the later gets a number at its end. *)

val listed : t -> (string * string) list
(** Each name with its text, in the order in which they were given. *)
