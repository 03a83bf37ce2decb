open Scc_exact
open Scc_polyhedra
open Scc_svg
open Scc_calculus

type t = { letter : string; colour : string; hatched : bool; name : string; share : string; told : string }

let shown (ranges : Ranges.t) (view : Plane.view) : Ranges.t =
  let end_ value : Ranges.bound = { value; included = true } in
  let height : Ranges.range = { name = ""; low = end_ Rat.zero; high = end_ Rat.one } in
  [| ranges.(view.across); (match view.up with Some up -> ranges.(up) | None -> height) |]

let projected (ranges : Ranges.t) view = List.map (Array.get ranges) (Plane.hidden ranges view)

let caption (ranges : Ranges.t) (view : Plane.view) =
  let fixed (i, x) = ranges.(i).name ^ " = " ^ Rat.to_string x in
  let any r = "any " ^ Ranges.range_to_string r in
  String.concat ", " (List.map fixed view.fixed @ List.map any (projected ranges view))

(* {1 Colours} *)

let nothing = "#888888"

let colour = Palette.colour

let letter i =
  let letter = String.make 1 (Char.chr (Char.code 'A' + (i mod 26))) in
  if i < 26 then letter else letter ^ string_of_int (i / 26)

(* {1 Words} *)

let of_one ~on : Plane.outcome -> string = function
  | Holds -> "holds"
  | Fails -> "fails"
  | Unknown -> "not known"
  | Varies -> "depends on " ^ on

let of_several ~on names outcomes =
  let those wanted = List.concat (List.map2 (fun n o -> if o = wanted then [ n ] else []) names outcomes) in
  let with_ suffix = List.map (fun name -> name ^ suffix) in
  match
    those Plane.Holds @ with_ (" (depends on " ^ on ^ ")") (those Varies) @ with_ " (not known)" (those Unknown)
  with
  | [] -> "none"
  | some -> String.concat ", " some

let most_pieces = 12

let where shown set =
  let pieces = Union.pieces set in
  let told = List.map (Words.piece shown) (List.filteri (fun i _ -> i < most_pieces) pieces) in
  let more = if List.compare_length_with pieces most_pieces > 0 then [ "..." ] else [] in
  String.concat "\nor " (told @ more)

let extent (view : Plane.view) = if view.up = None then 1 else 2

let share ranges (view : Plane.view) (r : Plane.region) =
  if Rat.sign r.share = 0 then Words.without_extent (extent view)
  else if view.fixed = [] && projected ranges view = [] then "probability " ^ Words.number r.share
  else Words.number r.share ^ if view.up = None then " of the length" else " of the area"

let make ranges view names regions =
  let on = String.concat ", " (List.map (fun (r : Ranges.range) -> r.name) (projected ranges view)) in
  let shown = shown ranges view in
  let fails (r : Plane.region) = List.for_all (fun o -> o = Plane.Fails) r.outcomes in
  let entry i (r : Plane.region) =
    let each = List.map2 (fun name o -> name ^ ": " ^ of_one ~on o) names r.outcomes in
    let name =
      match r.outcomes with
      | [ only ] -> of_one ~on only
      | several -> of_several ~on names several
    in
    let share = share ranges view r in
    {
      letter = letter i;
      colour = (if fails r then nothing else colour i);
      hatched = List.mem Plane.Unknown r.outcomes;
      name;
      share;
      told = String.concat "\n" (each @ [ "where " ^ where shown r.set; share ]);
    }
  in
  List.mapi entry regions
