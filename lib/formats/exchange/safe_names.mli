(** Names for tools that take letters, digits and underscores only. *)

type t
(** Which names are taken, and by which texts. *)

val make : reserved:string list -> t

val name : t -> string -> string
(** The name of a text: the same each time, another one for each text, and none of the reserved ones. It
    begins with a letter, has at most 64 characters, and tells the text as well as it can: [x(p) <= 3] is
    [x_p_le_3], [time(1/2)] is [time_1_over_2]; where two texts would have one name, the later gets a number
    behind it. Texts are to be given in a fixed order, since names depend on it. *)

val listed : t -> (string * string) list
(** Each name with its text, in the order in which they were given. *)
