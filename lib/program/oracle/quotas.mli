(** The limits of the service (see [specs/oracle.md]). A request beyond a limit is refused before any work is
    done. *)

(** The limits by name. *)
type t = {
  line_bytes : int;
  batch : int;
  reply_bytes : int;
  depth : int;
  values : int;
  digits : int;
  vertices : int;
  faces : int;
  corners : int;
  name_bytes : int;
  shapes : int;
  models : int;
  model_bytes : int;
  path : int;
  steps : int;
  touching : int;
  grid : int;
  formula_bytes : int;
  states : int;
  seconds : int;
  memory_mib : int;
}

val default : t
(** The limits of [specs/oracle.md]. *)

val listed : t -> (string * int) list
(** The limits with the names of their fields. *)

val default_states : int
(** The limit of states for the exploration of a temporal formula, unless the request sets another: 100 000. *)
