(** JSON Schemas (draft 2020-12) as data, as far as the formats of scc need them. *)

(** A set of characters, such as ["0-9a-f"], and how many of them in a row: at least [least], and at most [most] if
    there is a bound. *)
type run = { set : string; least : int; most : int option }

(** A set of values of JSON. *)
type t =
  | Anything
  | Null
  | Bool
  | Integer of { least : int option; most : int option }
  | Text of { least : int }  (** a string of at least so many characters *)
  | Form of run list  (** a string that consists of these runs, one after the other *)
  | Repeated of run list  (** a string that consists of such strings, one or more *)
  | Constant of Json.t list  (** one of these values *)
  | Items of { each : t; least : int; most : int option; distinct : bool }  (** an array *)
  | Tuple of t list  (** an array of as many items, each of which has its own schema *)
  | Members of member list  (** an object with these members and no others *)
  | Entries of t  (** an object with any names of members, whose values are all of one kind *)
  | Any_of of t list
  | Reference of { file : string; name : string; target : t Lazy.t }
  (** a definition by its name in [FILE.schema.json] *)
  | Document of { file : string; target : t }  (** the whole document that [FILE.schema.json] describes *)
  | About of string * t  (** with a description *)
  | Also of (string * Json.t) list * t  (** with further keywords, as they stand in the schema *)

and member = { name : string; required : bool; value : t }

val pattern : run list -> string
(** The regular expression of a form, from the start of the string to its end. *)

val repeated_pattern : run list -> string
(** The regular expression of strings of the form, one or more, one after the other. *)

val matches : ?again:bool -> run list -> string -> bool
(** [matches runs s] is true if [s] is of the form; with [again], if it consists of one or more strings of it. Each
    run takes as many characters as it can, so a run must not begin with characters that the run before it may take
    as well. *)

(** A file of schemas. *)
type file = {
  name : string;  (** the file is [NAME.schema.json] *)
  title : string;
  root : t option;  (** the schema of a whole document; a file without one has definitions only *)
  parts : t list;  (** schemas whose definitions are kept, though the schema of no whole document refers to them *)
}

val document : all:file list -> file -> Json.t
(** The schema of a file. Its definitions are those that the files of [all] refer to, in the order of their
    names. *)
