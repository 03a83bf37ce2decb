(** The edges of the states of a graph: 8 bytes for each edge and 12 for each state. *)

type t

val create : unit -> t

val make_room : t -> unit
(** For one state more, without edges as yet. *)

val set : t -> int -> labels:int array -> targets:int array -> unit
(** The labels and targets of the edges of a state, once. *)

val get : t -> int -> (int -> int -> 'edge) -> 'edge array
(** [get s i edge]: the edges of a state, made from labels and targets. *)

val targets : t -> int -> (int -> bool) -> int array
(** The targets of those edges of a state whose labels satisfy the test. *)

val find_label : t -> int -> (int -> bool) -> int option
(** The first label of the edges of a state that satisfies the test. *)

val bytes : t -> int
(** About how much memory it takes. *)
