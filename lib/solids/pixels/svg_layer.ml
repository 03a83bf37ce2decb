open Scc_exact

(* The opacity is between [low / whole] and [high / whole]. The levels of red, green and blue, times the lower
   opacity, are over [whole] too. Equal ids are equal pixels. *)
type pixel = { id : int; whole : Z.t; low : Z.t; high : Z.t; levels : Z.t * Z.t * Z.t }
type source = pixel

type store = Whole of pixel array | Sparse of (int, pixel) Hashtbl.t
type t = { store : store; last : int ref  (** the last id of a pixel *) }

let empty = { id = 0; whole = Z.one; low = Z.zero; high = Z.zero; levels = (Z.zero, Z.zero, Z.zero) }

let source ?upper ~rgb alpha =
  let upper = Option.value upper ~default:alpha in
  if Rat.sign upper <= 0 then None
  else begin
    let whole = Z.lcm alpha.den upper.den in
    let over (q : Rat.t) = Z.mul q.num (Z.divexact whole q.den) in
    let low = over alpha in
    let level shift = Z.mul low (Z.of_int ((rgb lsr shift) land 255)) in
    Some { id = 0; whole; low; high = over upper; levels = (level 16, level 8, level 0) }
  end

let whole n = { store = Whole (Array.make n empty); last = ref 0 }
let above layer = { layer with store = Sparse (Hashtbl.create 16) }

let get layer k =
  match layer.store with
  | Whole pixels -> pixels.(k)
  | Sparse pixels -> Option.value (Hashtbl.find_opt pixels k) ~default:empty

let set layer k pixel =
  match layer.store with Whole pixels -> pixels.(k) <- pixel | Sparse pixels -> Hashtbl.replace pixels k pixel

let fresh layer pixel =
  incr layer.last;
  { pixel with id = !(layer.last) }

(* {1 Over} *)

(* Each paint that is not opaque makes the numbers of a pixel longer, by some bits. *)
let max_bits = 4096

let opaque pixel = Z.equal pixel.low pixel.whole

let over above below =
  if opaque above || below == empty then above
  else begin
    let ( * ) = Z.mul and ( + ) = Z.add and ( - ) = Z.sub in
    let whole = above.whole * below.whole in
    if Z.numbits whole > max_bits then
      raise (Svg_number.Unread "more than some hundred paints over each other that are not opaque");
    let through = above.whole - above.low in
    let level a b = (a * below.whole) + (through * b) in
    let r, g, b = above.levels and r', g', b' = below.levels in
    let low = level above.low below.low in
    let high = (above.high * below.whole) + ((above.whole - above.high) * below.high) in
    { id = 0; whole; low; high; levels = (level r r', level g g', level b b') }
  end

(* Over a pixel of a layer, once for each key. *)
let composed ~cost layer known (key : int * int) ~source below =
  match Hashtbl.find_opt known key with
  | Some found -> found
  | None ->
    let found = fresh layer (over (source ()) below) in
    cost (Z.size found.whole);
    Hashtbl.replace known key found;
    found

let painter ~cost layer source =
  if opaque source then begin
    let source = fresh layer source in
    fun k -> set layer k source
  end
  else begin
    let known = Hashtbl.create 16 in
    fun k ->
      let below = get layer k in
      set layer k (composed ~cost layer known (0, below.id) ~source:(fun () -> source) below)
  end

let faded (alpha : Rat.t) p =
  let times = Z.mul alpha.num in
  let r, g, b = p.levels in
  let levels = (times r, times g, times b) in
  { p with whole = Z.mul p.whole alpha.den; low = times p.low; high = times p.high; levels }

let put ~cost layer ~onto alpha =
  let known = Hashtbl.create 16 in
  let one k p =
    let below = get onto k in
    set onto k (composed ~cost onto known (p.id, below.id) ~source:(fun () -> faded alpha p) below)
  in
  if Rat.sign alpha > 0 then
    match layer.store with
    | Whole pixels -> Array.iteri (fun k p -> if p.id > 0 then one k p) pixels
    | Sparse pixels -> Hashtbl.iter one pixels

(* {1 The result} *)

type seen = Transparent | Seen of int | Open

let seen layer k =
  let p = get layer k in
  let half q = Z.geq (Z.shift_left q 1) p.whole in
  if not (half p.high) then Transparent
  else if not (half p.low) then Open
  else begin
    let level q = Z.to_int (Z.div (Z.add (Z.shift_left q 1) p.low) (Z.shift_left p.low 1)) in
    let r, g, b = p.levels in
    Seen ((level r lsl 16) lor (level g lsl 8) lor level b)
  end
