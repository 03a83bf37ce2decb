open Scc_base
open Scc_exact

type t = { bodies : string list; lattice : Diffusion.lattice; at : Span.t }

let family name = match String.index_opt name '[' with Some i -> String.sub name 0 i | None -> name

let same (a : Diffusion.lattice) (b : Diffusion.lattice) =
  Rat.equal a.kick b.kick && Rat.equal a.spread b.spread && Bool.equal a.chosen b.chosen
  && Option.equal Rat.equal a.spin b.spin

module Names = Set.Make (String)

let once names =
  let add (seen, kept) name = if Names.mem name seen then (seen, kept) else (Names.add name seen, name :: kept) in
  List.rev (snd (List.fold_left add (Names.empty, []) names))

(* The bodies of each are gathered in reverse. *)
let of_bodies bodies =
  let add found (name, lattice, at) =
    let one = { bodies = [ family name ]; lattice; at } in
    let joined l = if same l.lattice lattice then Some { l with bodies = family name :: l.bodies } else None in
    Scc_data.Lists.put joined one found
  in
  List.map (fun l -> { l with bodies = once (List.rev l.bodies) }) (List.fold_left add [] bodies)

(* {1 Words} *)

let most_names = 3

let names l =
  let more = List.length l.bodies - most_names in
  String.concat ", " (List.filteri (fun i _ -> i < most_names) l.bodies)
  ^ if more > 0 then Printf.sprintf " and %d more" more else ""

let why (l : Diffusion.lattice) =
  "the least power of two whose square is no less than " ^ Rat.to_string l.spread

let entries what (l : Diffusion.lattice) =
  let chosen = if l.chosen then [ (what ^ " chosen as", why l) ] else [] in
  let spin = List.map (fun w -> ("spin of " ^ what, Rat.to_string w)) (Option.to_list l.spin) in
  ((what, Rat.to_string l.kick) :: chosen) @ spin

let settings = function
  | [ l ] -> entries "kick" l.lattice
  | lattices -> List.concat_map (fun l -> entries ("kick of " ^ names l) l.lattice) lattices

let line lattices =
  match settings lattices with
  | [] -> None
  | settings -> Some (String.concat ", " (List.map (fun (name, value) -> name ^ " " ^ value) settings))

let kicks lattices =
  match List.sort_uniq Rat.compare (List.map (fun l -> l.lattice.kick) lattices) with
  | [ kick ] -> Rat.to_string kick
  | _ -> String.concat "; " (List.map (fun l -> names l ^ " " ^ Rat.to_string l.lattice.kick) lattices)

let changed lattices ~from =
  let meets a b = List.exists (fun name -> List.mem name b.bodies) a.bodies in
  let change l =
    let other o = meets l o && not (Rat.equal o.lattice.kick l.lattice.kick) in
    if l.lattice.chosen then Option.map (fun o -> (l, o.lattice.kick)) (List.find_opt other from) else None
  in
  List.find_map change lattices
