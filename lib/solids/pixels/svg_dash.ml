open Scc_exact
open Svg_curve

type run =
  | Ring of Svg_chain.strand list
  | Open of Svg_chain.strand list
  | Dot of Plane_map.point * Plane_map.point

(* The place in it where lines begin: the length of a number, and what is left of it. Even ones are dashes. *)
type pattern = { lengths : Rat.t array; first : int; left : Rat.t }

let pattern lengths ~offset =
  let period = List.fold_left Rat.add Rat.zero lengths in
  let lengths = Array.of_list lengths in
  let rec from k rest =
    let beyond = Rat.compare rest lengths.(k) in
    if beyond > 0 || (beyond = 0 && Rat.sign rest > 0) then from (k + 1) (Rat.sub rest lengths.(k))
    else { lengths; first = k; left = Rat.sub lengths.(k) rest }
  in
  from 0 (Rat.modulo offset period)

(* A dash that is being drawn: its strands so far, and the places of the one that goes on, in reverse. *)
type pen = {
  pattern : pattern;
  budget : Svg_polygon.budget;
  mutable at : int;
  mutable left : Rat.t;
  mutable leaves : Plane_map.point;
  mutable places : Plane_map.point list;
  mutable strands : Svg_chain.strand list;
  mutable runs : run list;
}

let draws p = p.at land 1 = 0

let reach p place =
  match p.places with
  | last :: _ when same last place -> ()
  | _ -> p.places <- place :: p.places

let end_strand p arrives =
  match p.places with
  | [] | [ _ ] -> ()
  | places -> p.strands <- { Svg_chain.places = List.rev places; leaves = p.leaves; arrives } :: p.strands

(* A dash ends, or begins, at a place on a chord of this direction. *)
let switch p place along =
  Svg_polygon.spend p.budget 1;
  if draws p then begin
    reach p place;
    end_strand p along;
    p.runs <- (if p.strands = [] then Dot (place, along) else Open (List.rev p.strands)) :: p.runs;
    p.strands <- []
  end;
  p.at <- (p.at + 1) mod Array.length p.pattern.lengths;
  p.left <- p.pattern.lengths.(p.at);
  p.leaves <- along;
  p.places <- [ place ]

let chord p a b =
  let along = b -: a in
  let length = Rat.root (dot along along) in
  let rec from gone =
    let upto = Rat.add gone p.left in
    if Rat.compare upto length > 0 then p.left <- Rat.sub upto length
    else begin
      switch p (a +: (Rat.div upto length *: along)) along;
      from upto
    end
  in
  from Rat.zero;
  if draws p then reach p b

let strand p (s : Svg_chain.strand) =
  p.leaves <- s.leaves;
  p.places <- [ List.hd s.places ];
  let rec along = function
    | a :: (b :: _ as rest) ->
      chord p a b;
      along rest
    | [ _ ] | [] -> ()
  in
  along s.places;
  if draws p then end_strand p s.arrives

let cut ~budget pattern (line : Svg_chain.line) =
  let p =
    {
      pattern; budget; at = pattern.first; left = pattern.left; leaves = (Rat.zero, Rat.zero); places = [];
      strands = []; runs = [];
    }
  in
  List.iter (strand p) line.strands;
  let last = List.rev p.strands in
  let begun_drawn = pattern.first land 1 = 0 in
  match (last, List.rev p.runs) with
  | [], runs -> runs
  | _, [] when line.closed && begun_drawn -> [ Ring last ]
  | _, Open first :: rest when line.closed && begun_drawn -> Open (last @ first) :: rest
  | _, runs -> Open last :: runs
