(** The stated limits of the service (see [specs/oracle.md]): what is beyond one is refused before it is worked
    on. *)

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

val listed : t -> (string * int) list
(** By the names of the fields. *)

val default_states : int
(** Of the exploration of a temporal formula, when the request does not say: 100 000. *)
