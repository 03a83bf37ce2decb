(** Sparse matrices modulo a prime of 28 bits, as products of a lower and an upper triangular one (George and Liu,
    "Computer Solution of Large Sparse Positive Definite Systems", 1981, for the tree of the elimination). *)

type t

val prime_below : int -> int
(** [prime_below n] is the greatest prime that is less than [n], for 2 < [n] <= 2{^28}. *)

val compute :
  p:int ->
  order:int array ->
  neighbours:int array array ->
  row:(int -> (int -> int -> unit) -> unit) ->
  interrupted:(unit -> bool) ->
  t option
(** [compute ~p ~order ~neighbours ~row ~interrupted] is the factors of a matrix modulo the prime [p] < 2{^28},
    with pivots on the diagonal in this order. [neighbours] is as for {!Fill_order.compute}. [row i f] calls [f
    j a] for each entry [a] of row [i], from 0 to [p - 1], each column [j] once. It is [None] if a pivot is 0
    modulo [p], or if it is interrupted. *)

val entries : t -> int
(** [entries f] is the number of entries of both factors. *)

val solve : t -> int array -> unit
(** [solve f b] replaces [b], numbers from 0 to [p - 1], by the solution modulo [p]. *)
