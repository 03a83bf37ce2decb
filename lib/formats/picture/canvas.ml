open Scc_exact

type t = { width : int; height : int; unit_length : Rat.t; place : Ivec.t -> Rat.t * Rat.t }

let extent values = Rat.span (List.hd values) values

let two = Rat.of_int 2
let ceiling x = Z.to_int (Z.neg (Rat.floor (Rat.neg x)))

let make camera ~width ~margin ~top points =
  let along_right, along_up = Camera.lengths camera in
  let places = List.map Convex.place points in
  let left, right = extent (List.map fst places) and low, high = extent (List.map snd places) in
  let across = Rat.div (Rat.sub right left) along_right and upwards = Rat.div (Rat.sub high low) along_up in
  let room = Rat.of_int (width - (2 * margin)) in
  let most_high = Rat.div (Rat.mul room (Rat.of_int 4)) (Rat.of_int 3) in
  let unit_length =
    let by size room = if Rat.sign size > 0 then Some (Rat.div room size) else None in
    match (by across room, by upwards most_high) with
    | Some a, Some b -> Rat.min a b
    | Some a, None | None, Some a -> a
    | None, None -> Rat.one
  in
  let height = ceiling (Rat.mul upwards unit_length) + (2 * margin) + top in
  let middle = Rat.div (Rat.add left right) two in
  let place p =
    let x, y = Convex.place p in
    let pixels d along = Rat.div (Rat.mul d unit_length) along in
    ( Rat.add (Rat.make (Z.of_int width) (Z.of_int 2)) (pixels (Rat.sub x middle) along_right),
      Rat.add (Rat.of_int (margin + top)) (pixels (Rat.sub high y) along_up) )
  in
  { width; height; unit_length; place }

let framed ~width ~height ~top ~middle:(mx, my) ~half:(half_x, half_y) ~unit_length =
  let w = Rat.of_int width and h = Rat.of_int height in
  let place p =
    let x, y = Convex.place p in
    let along d half size = Rat.div (Rat.mul d size) (Rat.mul two half) in
    ( Rat.add (Rat.div w two) (along (Rat.sub x mx) half_x w),
      Rat.add (Rat.of_int top) (Rat.sub (Rat.div h two) (along (Rat.sub y my) half_y h)) )
  in
  { width; height = height + top; unit_length; place }

let bar t ~most =
  let most = Rat.div (Rat.of_int most) t.unit_length in
  let n = Decimal.order_of_magnitude most in
  let power = if n >= 0 then Q.of_bigint (Z.pow (Z.of_int 10) n) else Rat.make Z.one (Z.pow (Z.of_int 10) (-n)) in
  let times k = Rat.mul (Rat.of_int k) power in
  List.find (fun l -> Rat.compare l most <= 0) [ times 5; times 2; times 1 ]
