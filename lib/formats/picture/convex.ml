open Scc_exact

type t = Ivec.t array

let point x y w : Ivec.t = Ivec.primitive (Ivec.make x y w)
let place (p : Ivec.t) = (Rat.make p.x p.z, Rat.make p.y p.z)
let through p q = Ivec.primitive (Ivec.cross p q)

let sides t =
  let n = Array.length t in
  Array.init n (fun i -> through t.(i) t.((i + 1) mod n))

(* The corners of one side of the line, with the points where it crosses the boundary. A corner on the line
   belongs to both. *)
let half t values sign =
  let n = Array.length t in
  let kept = ref [] in
  for i = 0 to n - 1 do
    let j = (i + 1) mod n in
    let here = sign * Z.sign values.(i) and there = sign * Z.sign values.(j) in
    if here >= 0 then kept := t.(i) :: !kept;
    if here * there < 0 then begin
      let a = Z.abs values.(i) and b = Z.abs values.(j) in
      kept := Ivec.primitive (Ivec.add (Ivec.scale b t.(i)) (Ivec.scale a t.(j))) :: !kept
    end
  done;
  Array.of_list (List.rev !kept)

let cut t line =
  let values = Array.map (Ivec.dot line) t in
  let left = Array.exists (fun v -> Z.sign v > 0) values in
  let right = Array.exists (fun v -> Z.sign v < 0) values in
  match (left, right) with
  | true, true -> (Some (half t values 1), Some (half t values (-1)))
  | true, false -> (Some t, None)
  | false, true -> (None, Some t)
  | false, false -> (None, None)

let split t lines =
  let rec from i t outside =
    if i = Array.length lines then Some (t, outside)
    else
      match cut t lines.(i) with
      | None, _ -> None
      | Some left, None -> from (i + 1) left outside
      | Some left, Some right -> from (i + 1) left (right :: outside)
  in
  from 0 t []

let of_sides least t p = Array.for_all (fun line -> Z.sign (Ivec.dot line p) >= least) (sides t)
let contains t p = of_sides 0 t p
let inside t p = of_sides 1 t p

let area2 t =
  let places = Array.map place t in
  let n = Array.length t in
  let sum = ref Rat.zero in
  for i = 0 to n - 1 do
    let x, y = places.(i) and x', y' = places.((i + 1) mod n) in
    sum := Rat.add !sum (Rat.sub (Rat.mul x y') (Rat.mul x' y))
  done;
  !sum

let middle t =
  let count = Rat.of_int (Array.length t) in
  let mean f = Rat.div (Array.fold_left (fun s p -> Rat.add s (f (place p))) Rat.zero t) count in
  let x = mean fst and y = mean snd in
  let p, w = Ivec.of_vec (Vec.make x y Rat.one) in
  point p.x p.y w
