(** The edges of the states of a graph: 8 bytes for each edge and 12 for each state. *)

type t

val create : unit -> t
(** [create ()] has no states. *)

val make_room : t -> unit
(** [make_room s] adds the next state, without edges yet. *)

val set : t -> int -> labels:int array -> targets:int array -> unit
(** [set s i ~labels ~targets] stores the edges of state [i]; it is called once for a state. *)

val get : t -> int -> (int -> int -> 'edge) -> 'edge array
(** [get s i edge] is the edges of state [i] in order, each made by [edge label target]. *)

val targets : t -> int -> (int -> bool) -> int array
(** [targets s i test] is the targets of those edges of state [i] whose labels pass the test, in order. *)

val find_label : t -> int -> (int -> bool) -> int option
(** [find_label s i test] is the first label of an edge of state [i] that passes the test. *)

val bytes : t -> int
(** [bytes s] is about how much memory the store takes, in bytes. *)
