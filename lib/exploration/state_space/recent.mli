(** A memory of what was asked for last, by numbers: one thing for each place, at the number modulo the size. It
    begins small and grows as long as much is asked for that is not there, up to a bound. What it holds is never
    needed, only found sooner. *)

type 'a t

val create : number:('a -> int) -> none:'a -> most:int -> 'a t
(** At most so many, a power of two. [none] stands in free places; its number is none that is asked for. *)

val get : 'a t -> int -> 'a
(** What is at the place of a number: perhaps of another number, or [none]. *)

val keep : 'a t -> 'a -> unit
