open Scc_exact
open Scc_rigid
open Scc_svg
open Scc_calculus
open Scc_semantics

type options = {
  from : Vec.t;
  up : Vec.t;
  width : int;
  names : bool;
  marks : bool;
  key : bool;
  bar : bool;
  title : string option;
  without : string list;
  page : Page_camera.t option;
}

let default =
  {
    from = Vec.of_ints 11 10 20;
    up = Vec.of_ints 0 1 0;
    width = 800;
    names = false;
    marks = true;
    key = true;
    bar = true;
    title = None;
    without = [];
    page = None;
  }

let none = function [] -> true | _ :: _ -> false

(* {1 What is there} *)

(* A leaf of the state. Each of its parts is a solid of the view, of this number, unless the part is left out. *)
type body = { leaf : State.leaf; of_model : Model.leaf; placed : Placed.t array; solids : int option array }

(* Does the name mean this part of the leaf: by itself, with all of the leaf, or with the leaf's whole family? *)
let means name (leaf : Model.leaf) (part : Model.part) =
  String.equal name leaf.name || String.equal name part.name || String.starts_with ~prefix:(name ^ "[") leaf.name

let unknown (m : Model.t) names =
  let known name = Array.exists (fun (leaf : Model.leaf) -> Array.exists (means name leaf) leaf.parts) m.leaves in
  List.find_opt (fun name -> not (known name)) names

let bodies ~without (m : Model.t) (state : State.t) =
  let add (next, found) (leaf : State.leaf) =
    let of_model = m.leaves.(leaf.leaf) in
    let placed = Array.mapi (fun i _ -> State.placed m leaf i) of_model.parts in
    let next = ref next in
    let solid part =
      if List.exists (fun name -> means name of_model part) without then None
      else begin
        incr next;
        Some (!next - 1)
      end
    in
    let solids = Array.map solid of_model.parts in
    (!next, { leaf; of_model; placed; solids } :: found)
  in
  let leaves = Array.concat (Array.to_list (Array.map (fun (p : State.process) -> p.leaves) state.processes)) in
  let order (a : State.leaf) (b : State.leaf) = Int.compare a.leaf b.leaf in
  let in_order = List.sort order (Array.to_list leaves) in
  List.rev (snd (List.fold_left add (0, []) in_order))

let drawn_solids b = List.filter_map Fun.id (Array.to_list b.solids)
let is_drawn b = not (none (drawn_solids b))

(* {1 Colours} *)

let fixed_colour = (0.80, 0.82, 0.84)
let absorber_colour = (0.58, 0.60, 0.64)

let colour (families : Families.t) b =
  if b.of_model.absorbs then absorber_colour
  else if b.of_model.fixed then fixed_colour
  else Palette.body families.of_leaf.(b.leaf.leaf)

(* {1 Marks} *)

let open_sites (m : Model.t) (leaf : State.leaf) =
  let sites : Behaviours.offer -> Site.t list = function
    | Offer_open (_, channel, _) -> channel.sites @ channel.only
    | Offer_weak _ | Offer_strong _ -> []
  in
  List.sort_uniq Site.compare (List.concat_map sites (Behaviours.offers m.definitions leaf.behaviour))

let open_features (m : Model.t) paint colour b =
  let sites = open_sites m b.leaf in
  let part i placed =
    match (b.solids.(i), Site.on i sites) with
    | None, _ | _, [] -> []
    | Some solid, features -> Marks.open_features paint (colour b) solid placed features
  in
  List.concat (Array.to_list (Array.mapi part b.placed))

let bond (m : Model.t) paint bodies (b : State.bond) =
  let body (f : State.finish) = List.find (fun body -> body.leaf.leaf = f.at) bodies in
  let shown (f : State.finish) = Option.is_some (body f).solids.(f.site.part) in
  let finish (f : State.finish) = ((body f).placed.(f.site.part), f.site.feature) in
  let name (f : State.finish) = Model.site_name m ~leaf:f.at f.site in
  let told = Printf.sprintf "<%s, {%s, %s}>" b.name (name b.one) (name b.two) in
  if shown b.one && shown b.two then Marks.bond paint ~told (finish b.one) (finish b.two) else []

(* {1 Names} *)

(* Where a name may be: in the middle of the largest pieces that are seen of its body. *)
let name (paint : Paint.t) b =
  let pieces =
    List.concat_map
      (fun solid -> List.concat_map (Hidden.pieces paint.hidden) paint.faces.(solid))
      (drawn_solids b)
  in
  let sized = List.map (fun p -> (Rat.near_float (Convex.area2 p), p)) pieces in
  let order (a, _) (b, _) = Float.compare b a in
  let largest = List.filteri (fun i _ -> i < 6) (List.stable_sort order sized) in
  let at = List.map (fun (_, p) -> paint.canvas.place (Convex.middle p)) largest in
  let size = List.fold_left (fun sum (a, _) -> sum +. a) 0. sized in
  { Marks.text = b.of_model.name; at; size; style = [] }

(* {1 The key} *)

let swatch text colour : Key.entry =
  { sample = Swatch { fill = Palette.hex colour; stroke = Palette.hex (Paint.ink colour) }; text }

(* The families that are there, each once. *)
let present (families : Families.t) bodies =
  let family b = families.of_leaf.(b.leaf.leaf) in
  let add found b =
    if b.of_model.fixed || List.exists (fun other -> family other = family b) found then found else b :: found
  in
  List.rev (List.fold_left add [] bodies)

let key families bodies ~hatch ~open_ ~bonds : Key.entry list =
  let exists test = List.exists (fun b -> test b.of_model) bodies in
  let dot = [ ("r", "3.2"); ("fill", Marks.bond_colour) ] in
  let bond_glyph =
    Svg.tag "path" [ ("d", "M-9 0 L9 0"); ("stroke", Marks.bond_colour); ("stroke-width", "1.4") ] []
    @ Svg.tag "circle" dot []
  in
  let of_family b = swatch families.Families.names.(families.of_leaf.(b.leaf.leaf)) (colour families b) in
  List.map of_family (present families bodies)
  @ (if exists (fun l -> l.fixed && not l.absorbs) then [ swatch "fixed" fixed_colour ] else [])
  @ (if exists (fun l -> l.absorbs) then [ swatch "absorbs" absorber_colour ] else [])
  @ (if open_ then [ { Key.sample = Hatch hatch; text = "open" } ] else [])
  @ if bonds then [ { Key.sample = Glyph bond_glyph; text = "bond" } ] else []

(* {1 Glass} *)

(* What is fixed, absorbs nothing and does nothing is a wall only; of other bodies something is to be seen. *)
let glass (m : Model.t) camera solids hidden bodies =
  let body b : Glass.body =
    let plain = b.of_model.fixed && not b.of_model.absorbs in
    let idle () = none (Behaviours.offers m.definitions b.leaf.behaviour) in
    { solids = drawn_solids b; wall = b.of_model.fixed; content = not (plain && idle ()) }
  in
  Glass.find camera solids hidden (Array.of_list (List.map body bodies))

(* The view without what glass would hide, if something is of glass. *)
let seen m camera ~origin solids bodies =
  let view = View.make camera ~origin solids in
  let opaque = Hidden.make view in
  let glass = glass m camera solids opaque bodies in
  if List.exists (fun b -> List.exists glass (drawn_solids b)) bodies then Hidden.make ~glass view else opaque

(* {1 All of it} *)

let told options bodies =
  match options.title with
  | Some title -> title
  | None -> String.concat ", " (List.map (fun b -> b.of_model.name) bodies)

let camera options =
  match options.page with
  | None -> Camera.make ~up:options.up options.from
  | Some page -> Page_camera.camera page

let canvas options camera ~origin hidden =
  let width = options.width and top = Sheet.top ~title:options.title in
  match options.page with
  | Some page -> Page_camera.canvas page camera ~origin ~width ~top
  | None ->
    let points = List.concat_map Array.to_list (Array.to_list (Hidden.view hidden).points) in
    let points = if none points then [ Convex.point Z.zero Z.zero Z.one ] else points in
    Canvas.make camera ~width ~margin:Sheet.margin ~top points

let drawn (m : Model.t) state options all =
  let bodies = List.filter is_drawn all in
  let of_body b = List.filteri (fun i _ -> Option.is_some b.solids.(i)) (Array.to_list b.placed) in
  let solids = List.concat_map of_body bodies in
  let camera = camera options in
  let whole (v : Vec.t) = Ivec.make (Rat.floor v.x) (Rat.floor v.y) (Rat.floor v.z) in
  let origin = match solids with [] -> Ivec.zero | p :: _ -> whole p.at in
  let hidden = seen m camera ~origin (Array.of_list (List.map View.of_placed solids)) bodies in
  let canvas = canvas options camera ~origin hidden in
  let paint = Paint.make camera ~origin canvas hidden in
  let families = Families.of_model m in
  let colour = colour families in
  let body ~glass b =
    let some = List.filter (fun s -> Bool.equal glass (Hidden.is_glass hidden s)) (drawn_solids b) in
    match List.concat_map (Paint.solid paint (colour b)) some with
    | [] -> []
    | painted -> Svg.tag "g" [] (Svg.title b.of_model.name @ painted)
  in
  let painted = List.concat_map (body ~glass:false) bodies @ List.concat_map (body ~glass:true) bodies in
  let opened = if options.marks then List.concat_map (open_features m paint colour) bodies else [] in
  let bonded = if options.marks then List.concat_map (bond m paint all) (State.bonds state) else [] in
  let names = if options.names then Marks.names ~width:canvas.width (List.map (name paint) bodies) else [] in
  let open_ = not (none opened) in
  let key =
    if options.key then key families bodies ~hatch:(Marks.hatch paint) ~open_ ~bonds:(not (none bonded)) else []
  in
  let defs = if open_ then Marks.pattern paint else [] in
  let sheet : Sheet.t =
    {
      size = (canvas.width, canvas.height);
      title = options.title;
      told = told options bodies;
      defs;
      bar = (if options.bar && not (none bodies) then Some canvas else None);
      key;
      notes = [];
    }
  in
  Sheet.svg sheet (painted @ opened @ bonded @ names)

let svg m state options = drawn m state options (bodies ~without:options.without m state)
