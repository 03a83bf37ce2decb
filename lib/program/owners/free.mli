(** Owners that do not wait for each other: each expands its states as they come. Verdicts and numbers are those
    of a search in step if it comes to its end. Runs are runs, but need not be the shortest ones. *)

type t

val make :
  Part.t -> Mesh.t -> Expansion.t -> searches:bool -> most_states:int -> show:(Progress.t -> unit) -> t
(** [make part mesh expansion ~searches ~most_states ~show] is one owner. With [searches] it ends once every goal
    is met. It ends when an owner has more than its share of [most_states]. [show] is called now and then. *)

val hear_states : t -> unit
(** A message with states has come, and was entered. *)

val heard : t -> int -> char -> string -> bool
(** [heard s peer kind text] answers another message. It is false if the message is of no kind. Raises
    [Packed.Malformed]. *)

val is_expanded : t -> int -> bool
(** [is_expanded f id] is true if the transitions of a state of this owner were found. *)

val run : t -> home:int -> Progress.t
(** The whole exploration, whose initial state is that of the owner [home]. *)
