(** Values by handle: ["s1"], ["s2"], …, up to a limit at a time. No handle is given twice. *)

(** Values with their handles. *)
type 'a t

val create : prefix:string -> limit:string -> most:int -> 'a t
(** No values yet. Handles begin with [prefix]; [limit] is the name of [most] in {!Quotas}. *)

val check_room : 'a t -> unit
(** Refuses with [Limit] if there is no room for another value. It is meant to be called before the value is
    computed. *)

val add : 'a t -> 'a -> string
(** Adds a value and gives it a new handle. *)

val get : 'a t -> string -> 'a
(** The value of a handle. An unknown or released handle is refused ([Unknown_handle]). *)

val release : 'a t -> string -> 'a
(** Removes a handle, and returns its value. An unknown handle is refused ([Unknown_handle]). *)

val iter : ('a -> unit) -> 'a t -> unit
(** Applies a function to all values. *)
