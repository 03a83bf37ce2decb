open Scc_base
open Scc_exact
open Scc_pixels

type pieces = Only of int option | Apart | Plate of Rat.t

type options = {
  background : int option;
  pieces : pieces;
  strength : Rat.t;
  colours : (int * Rat.t) list;
  shaded : bool;
  profile : Relief.profile;
  faces : [ `About of int | `Most of int | `All ];
  scale : Rat.t;
}

type t = { relief : Relief.t; solid : Solid_of.t; solids : Solid_of.t list }

let start path = Span.of_file path
let refuse ~path ?hint code format =
  Printf.ksprintf (fun m -> Error (Diag.error ?hint code (start path) "%s" m)) format

(* {1 The silhouette} *)

(* The first ones of a list, with how many there are besides. *)
let some text items =
  let shown = List.filteri (fun i _ -> i < 5) items in
  let more = List.length items - List.length shown in
  String.concat ", " (List.map text shown) ^ if more > 0 then Printf.sprintf " and %d more" more else ""

let pieces_text pieces =
  let numbered = List.mapi (fun i p -> (i + 1, p)) pieces in
  let one (i, (p : Silhouette.piece)) =
    Printf.sprintf "%d: %d %s from column %d, row %d on" i p.pixels
      (if p.pixels = 1 then "pixel" else "pixels")
      (fst p.at + 1) (snd p.at + 1)
  in
  some one numbered

(* The shape, and its pieces if they are wanted. *)
let silhouette ~path o (picture : Raster.t) =
  let found =
    match o.pieces with
    | Only piece ->
      Result.map (fun shape -> (shape, [ shape ])) (Silhouette.find ?background:o.background ?piece picture)
    | Apart | Plate _ -> Silhouette.find_all ?background:o.background picture
  in
  match found with
  | Ok found -> Ok found
  | Error Empty ->
    refuse ~path Code.no_silhouette
      ~hint:
        "a pixel is of the shape when it is opaque, in a picture with transparency, and otherwise when it is far \
         from white; --background tells another colour"
      "nothing is drawn here: no pixel differs from the background"
  | Error (Several pieces) ->
    refuse ~path Code.several_pieces
      ~hint:
        "--piece 1 takes the largest one, --pieces apart all of them, and --pieces plate puts them on a plate; \
         pixels that only touch at a corner do not hang together"
      "the drawing is in %d pieces (%s)" (List.length pieces) (pieces_text pieces)
  | Error (No_such_piece pieces) ->
    refuse ~path Code.several_pieces "there is no such piece: the drawing has %d (%s)" (List.length pieces)
      (pieces_text pieces)

(* {1 Strengths} *)

(* From 1 for black to 0 for white. *)
let darkness colour =
  let sum = (colour lsr 16) + ((colour lsr 8) land 255) + (colour land 255) in
  Rat.make (Z.of_int (765 - sum)) (Z.of_int 765)

let strengths ~path o shape =
  let colours = Silhouette.colours shape in
  let* () =
    match List.find_opt (fun (c, _) -> not (List.mem_assoc c colours)) o.colours with
    | None -> Ok ()
    | Some (c, _) ->
      let one (c, n) = Printf.sprintf "%s: %d" (Raster.colour_text c) n in
      refuse ~path Code.cannot_inflate
        ~hint:(Printf.sprintf "it has the colours (with their numbers of pixels) %s" (some one colours))
        "no pixel of the shape has the colour %s" (Raster.colour_text c)
  in
  let of_colour (c, _) =
    let told = Option.value (List.assoc_opt c o.colours) ~default:o.strength in
    (c, if o.shaded then Rat.mul told (darkness c) else told)
  in
  let table = Hashtbl.create 16 in
  List.iter (fun c -> let c, s = of_colour c in Hashtbl.replace table c s) colours;
  let greatest = Hashtbl.fold (fun _ s g -> Rat.max s g) table Rat.zero in
  if Rat.sign greatest <= 0 then
    refuse ~path Code.cannot_inflate "all pixels of the shape have the strength 0: it stays flat"
      ~hint:
        (if o.shaded then "--shaded gives white the strength 0: draw in a darker colour"
         else "give some colour a strength that is greater than 0")
  else Ok ((fun i -> Hashtbl.find table (Silhouette.colour shape i)), greatest)

(* {1 All of it} *)

(* Solids of reliefs with so many faces together, the smallest relief first. Each has a share of what is left by
   how many faces it has without simplification, or more where it needs more. The error is how many all may
   need. *)
let share ~progress ~scale ~most reliefs =
  let fewest = 8 in
  let rec go left weights solids = function
    | [] -> Ok solids
    | (everything, relief) :: rest -> (
        let others = List.length rest * fewest in
        let share = max fewest (left * everything / max 1 weights) in
        let made faces =
          if left - others < fewest then Error fewest
          else Solid_of.make ~progress ~faces:(Some (min faces (left - others))) ~scale relief
        in
        let found =
          match made share with
          | Error needed when needed <= left - others -> made needed
          | found -> found
        in
        match found with
        | Ok solid ->
          let used = Array.length solid.mesh.ifs_faces in
          go (left - used) (weights - everything) (solid :: solids) rest
        | Error needed -> Error (most - left + needed + others))
  in
  let weighted = List.map (fun r -> (Solid_of.everything r, r)) reliefs in
  let sorted = List.stable_sort (fun (m, _) (n, _) -> Int.compare m n) weighted in
  go most (List.fold_left (fun n (m, _) -> n + m) 0 sorted) [] sorted

let solids ~progress o reliefs =
  let scale = o.scale in
  let one faces relief = Solid_of.make ~progress ~faces ~scale relief in
  let at_most n =
    match reliefs with
    | [ relief ] -> Result.map (fun solid -> [ solid ]) (one (Some n) relief)
    | _ -> share ~progress ~scale ~most:n reliefs
  in
  let rec about n =
    match at_most n with Error needed -> about (max needed (2 * n)) | found -> found
  in
  match o.faces with
  | `All -> Result.all (one None) reliefs
  | `Most n -> at_most n
  | `About n -> about n

(* What is connected, each by itself; [None] if it is too high. *)
let reliefs o (relief : Relief.t) pieces =
  match o.pieces with
  | Only _ -> Some [ relief ]
  | Apart -> Some (List.map (Relief.part relief) pieces)
  | Plate height ->
    let plate = Z.max Z.one (Rat.floor (Rat.mul height (Rat.of_int Relief.quanta))) in
    if Z.gt (Z.add plate (Z.of_int relief.highest)) (Z.of_int (Relief.most * Relief.quanta)) then None
    else Some [ Relief.on_plate relief ~margin:2 ~plate:(Z.to_int plate) ]

let make ~progress ~path o picture =
  let* shape, pieces = silhouette ~path o picture in
  let* strength, greatest = strengths ~path o shape in
  let diffusion = Diffusion.solve ~progress:(progress "inflating") shape ~strength ~greatest in
  let found =
    let*? relief = Relief.make o.profile shape diffusion ~greatest in
    Option.map (fun all -> (relief, all)) (reliefs o relief pieces)
  in
  match found with
  | None ->
    refuse ~path Code.cannot_inflate ~hint:"choose smaller strengths, and --scale to make all of it larger"
      "with these strengths it would be higher than %d pixels" Relief.most
  | Some (relief, all) -> (
      let highest = List.fold_left (fun h (r : Relief.t) -> Int.max h r.highest) 0 all in
      let relief = { relief with highest } in
      match solids ~progress:(progress "simplifying") o all with
      | Ok [ solid ] -> Ok { relief; solid; solids = [ solid ] }
      | Ok solids -> Ok { relief; solid = Solid_of.together solids; solids }
      | Error needed ->
        refuse ~path Code.cannot_inflate
          ~hint:(Printf.sprintf "allow more, at least --faces %d, or all of them: --faces all" needed)
          "the drawing cannot be had with so few faces")
