open Bigarray

type t = (int32, int32_elt, c_layout) Array1.t

let max_value = 0x7fffffff
let raw n : t = Array1.create Int32 C_layout n
let get (a : t) i = Int32.to_int (Array1.get a i)
let unsafe_get (a : t) i = Int32.to_int (Array1.unsafe_get a i)
let set (a : t) i x = Array1.set a i (Int32.of_int x)
let length (a : t) = Array1.dim a
let fill (a : t) x = Array1.fill a (Int32.of_int x)

let make n x =
  let a = raw n in
  fill a x;
  a

let prefix (a : t) n : t = Array1.sub a 0 n

type buffer = { mutable data : t; mutable used : int }

let buffer () = { data = raw 16; used = 0 }
let size b = b.used
let checked b i = if i < b.used then i else invalid_arg "Int_array: an index beyond the size of a buffer"
let nth b i = get b.data (checked b i)
let put b i x = set b.data (checked b i) x

let grow b =
  let wider = raw (2 * length b.data) in
  Array1.blit b.data (Array1.sub wider 0 b.used);
  b.data <- wider

let push b x =
  if b.used = length b.data then grow b;
  set b.data b.used x;
  b.used <- b.used + 1

let pop b =
  let last = nth b (b.used - 1) in
  b.used <- b.used - 1;
  last

let clear b = b.used <- 0

let contents b =
  let a = raw b.used in
  Array1.blit (Array1.sub b.data 0 b.used) a;
  a
