(** Runs to states, found backwards by the ways of the owners: each goes as far as its states lead, and then asks
    the next one. *)

type t

val kind : char
(** The kind of messages that ask an owner to go on. *)

val told : char
(** The kind of messages that tell the first owner of a run. *)

val make : Mesh.t -> Part.t -> find:(level:int -> int -> int option) -> is_root:(int -> bool) -> t
(** [make mesh part ~find ~is_root] is for one owner. [find ~level before] is its state of a level that the ways
    of other states call [before], and [is_root] is true for the initial state. *)

val heard : t -> char -> string -> unit
(** Answers a message of one of the kinds. *)

val all : t -> Progress.place option array -> (int * int list) list
(** [all t met] is begun by all owners, with the same places. For the first one it is the choices of a run to
    each of the places, by goals. The others get what they happen to know, at once, and go on answering. *)
