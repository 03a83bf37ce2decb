(** One file of SQLite: what it answers as results, or as {!Failed}. *)

open Scc_base

type t = Sqlite3.db

exception Failed of Code.t * string
(** What is wrong, by one of the codes of stores. *)

val fail : Code.t -> ('a, unit, string, 'b) format4 -> 'a

val damaged : string -> 'a
(** {!Failed} (SC0912), with what is. *)

val caught : (unit -> 'a) -> ('a, Code.t * string) result
(** What {!Failed} tells, and what SQLite raises by itself. *)

val open_to_write : string -> t
(** Makes the file if it is not there. *)

val open_to_read : string -> t
(** A file that nobody can write to, or that lies where nobody can. It must not have been left by a process that
    was killed: then some of it is in other files (SC0910). *)

val close : t -> unit

val run : t -> string -> unit
(** One statement, without answers. *)

val change : t -> string -> Sqlite3.Data.t list -> unit
(** The same, with values for its question marks. *)

val fold : t -> string -> Sqlite3.Data.t list -> ('a -> Sqlite3.stmt -> 'a) -> 'a -> 'a
(** The rows of a query. *)

val number : t -> string -> int
(** The one number that a query answers; 0 if it does not. *)

val look_through : t -> unit
(** That all of its pages fit together, also those that are read when something is added. *)
