open Scc_exact

(* Sides of pieces lie on lines. Along each line, in one of its directions, every side is worth 1 where it runs
   that way and -1 where it runs back; the border is where the sum is not 0. *)

module Table = Hashtbl.Make (struct
    type t = Ivec.t

    let equal = Ivec.equal
    let hash = Ivec.hash
  end)

let opposite (line : Ivec.t) =
  match (Z.sign line.x, Z.sign line.y) with 0, y -> y < 0 | x, _ -> x < 0

(* The order of points along a line, backwards or not: by x, and on a vertical one by y. *)
let compare_along (line : Ivec.t) (p : Ivec.t) (q : Ivec.t) =
  let order a b = Z.compare (Z.mul a q.z) (Z.mul b p.z) in
  if Z.sign line.y <> 0 then order p.x q.x else order p.y q.y

type side = { from : Ivec.t; till : Ivec.t; worth : int }

let on_lines pieces =
  let table = Table.create 64 in
  let add piece i side =
    let n = Array.length piece in
    let back = opposite side in
    let line = if back then Ivec.neg side else side in
    let p = piece.(i) and q = piece.((i + 1) mod n) in
    let worth = if compare_along line p q < 0 then 1 else -1 in
    let from, till = if worth > 0 then (p, q) else (q, p) in
    Table.replace table line ({ from; till; worth } :: Option.value ~default:[] (Table.find_opt table line))
  in
  List.iter (fun piece -> Array.iteri (add piece) (Convex.sides piece)) pieces;
  table

(* The parts of one line that are border, as directed segments. *)
let border line sides =
  let compare = compare_along line in
  let ends =
    List.concat_map (fun s -> [ (s.from, s.worth); (s.till, -s.worth) ]) sides
    |> List.sort (fun (p, _) (q, _) -> compare p q)
  in
  let directed p q sum = if sum > 0 then (p, q) else (q, p) in
  (* [start] is where the sum has come to be what it is. *)
  let rec walk start sum found = function
    | [] -> found
    | (p, worth) :: rest ->
      let rec all sum = function
        | (q, worth) :: rest when compare p q = 0 -> all (sum + worth) rest
        | rest -> (sum, rest)
      in
      let after, rest = all (sum + worth) rest in
      if after = sum then walk start sum found rest
      else walk p after (if sum = 0 then found else directed start p sum :: found) rest
  in
  match ends with [] -> [] | (first, _) :: _ -> walk first 0 [] ends

let chained segments =
  let onward = Table.create 64 in
  let add (p, q) = Table.replace onward p (q :: Option.value ~default:[] (Table.find_opt onward p)) in
  List.iter add segments;
  let next p =
    match Table.find_opt onward p with
    | None | Some [] -> None
    | Some (q :: others) ->
      Table.replace onward p others;
      Some q
  in
  let rec loop start path p =
    match next p with
    | None -> Scc_base.Bug.fail __POS__ "the border of a region is not closed"
    | Some q -> if Ivec.equal q start then List.rev path else loop start (q :: path) q
  in
  let from found (p, _) =
    match next p with
    | None -> found
    | Some q -> loop p [ q; p ] q :: found
  in
  List.rev (List.fold_left from [] segments)

let by_ends (p, q) (r, s) =
  Ivec.compare p r <?> fun () -> Ivec.compare q s

let loops = function
  | [ piece ] -> [ Array.to_list piece ]
  | pieces ->
    let table = on_lines pieces in
    (* In an order that does not depend on that of the table. *)
    let segments = Table.fold (fun line sides found -> border line sides @ found) table [] in
    chained (List.sort by_ends segments)
