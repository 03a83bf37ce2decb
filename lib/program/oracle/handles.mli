(** Things by handle: ["s1"], ["s2"], … as many at a time as there may be, and no handle twice. *)

type 'a t

val create : prefix:string -> limit:string -> most:int -> 'a t
(** [limit] is the name of [most] in {!Quotas}. *)

val check_room : 'a t -> unit
(** Refuses when there are as many as there may be: to be asked before the work is done. *)

val add : 'a t -> 'a -> string
val find : 'a t -> 'a Read.reader
val get : 'a t -> string -> 'a
(** Refuses a handle that was never given, or was released. *)

val release : 'a t -> string -> 'a
val iter : ('a -> unit) -> 'a t -> unit
