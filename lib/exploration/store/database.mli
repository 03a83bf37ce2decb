(** One SQLite file. Its errors become {!Failed}. *)

open Scc_base

type t = Sqlite3.db

exception Failed of Code.t * string
(** A failed operation: a code of stores (SC0910, SC0911 or SC0912), and a sentence. *)

val fail : Code.t -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Failed} with this code and the formatted text. *)

val damaged : string -> 'a
(** [damaged what] raises {!Failed} with SC0912: the store is damaged, and [what] names the damage. *)

val caught : (unit -> 'a) -> ('a, Code.t * string) result
(** [caught f] is the result of [f ()], or the code and text of its {!Failed}. Exceptions of SQLite itself count
    as damage (SC0912). *)

val open_to_write : string -> t
(** Opens the file at this path to read and write. A file that does not exist is made. Raises {!Failed}: SC0910
    if it cannot be opened, SC0912 if its header is not that of a database. *)

val open_to_read : string -> t
(** Opens a file that this process cannot write to, as immutable. Raises {!Failed}: SC0910 if another process has
    locked it, or if a killed process left some of its data in other files; SC0912 if its header is not that of a
    database. *)

val close : t -> unit
(** Closes the file. *)

val run : t -> string -> unit
(** [run db sql] executes one statement and ignores its rows. *)

val change : t -> string -> Sqlite3.Data.t list -> unit
(** [change db sql values] executes one statement with [values] for its question marks, in order. *)

val fold : t -> string -> Sqlite3.Data.t list -> ('a -> Sqlite3.stmt -> 'a) -> 'a -> 'a
(** [fold db sql values add start] folds [add] over the rows of a query, in their order. [values] are those of its
    question marks. *)

val number : t -> string -> int
(** [number db sql] is the first column of the last row of a query, if it is an integer; else 0. *)

val look_through : t -> unit
(** Checks the integrity of the whole file: all pages fit together, including those that are read only when
    something is added. Raises {!Failed} with SC0912 if not. *)
