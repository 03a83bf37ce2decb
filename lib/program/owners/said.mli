(** What an owner and the process that has started it say to each other ([specs/successors.md]): lines of JSON. *)

(** How states are taken: level by level ({!In_step}), in the order of time ({!By_time}), or as they come
    ({!Free}). *)
type order = Levels | Time | Any

val order_name : order -> string
(** The order in a word. *)

(** The first line of the input: with whom it explores, and how. *)
type begin_ = {
  peers : (string * int) list;  (** host and port of each owner *)
  secret : string;
  run : string;  (** any text; that of other owners must be the same *)
  order : order;
  states : int option;  (** the most *)
  deadline : int;  (** milliseconds within which all owners have to come *)
  every : int option;  (** milliseconds between levels that are kept *)
  folder : string option;  (** where they are written, and tables that are too large *)
  memory : int option;  (** MiB beyond which tables are in files *)
  restore : string list;  (** files to begin with *)
  evaluate : bool;  (** properties that are more than searches are evaluated *)
}

val read_begin : count:int -> string -> begin_
(** Reads the line. Raises {!Failure.Failed}. *)

(** A run that comes back within one instant: its choices, and how many of them lead to the state to which it comes
    back. *)
type lasso = { choices : int list; from : int }

(** The result of an exploration, which the first owner tells. *)
type found = {
  progress : Progress.t;
  runs : (int * int list) list;  (** by goal that is met, the choices of a run to it *)
  cycle : lasso option;  (** in which no time passes, if one was found *)
  conclusions : Conclusion.t list;  (** of properties that are more than searches *)
  messages : int;  (** between all owners *)
  bytes : int;
}

(** A line of the output, after the header. *)
type t =
  | Going of Progress.t  (** now and then, of the first owner *)
  | Kept of { level : int; from : int; file : string; progress : Progress.t }
  (** levels have been written to a file, from one on *)
  | Found of found

val format : (t, unit) Scc_json.Json_format.t
(** The format of a line. *)

val line : t -> string
(** The line, without a line end. *)
