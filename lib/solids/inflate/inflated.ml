open Scc_base
open Scc_exact
open Scc_pixels

type options = {
  background : int option;
  piece : int option;
  strength : Rat.t;
  colours : (int * Rat.t) list;
  shaded : bool;
  profile : Relief.profile;
  faces : int option;
  scale : Rat.t;
}

type t = { relief : Relief.t; solid : Solid_of.t }

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

let silhouette ~path o (picture : Raster.t) =
  match Silhouette.find ?background:o.background ?piece:o.piece picture with
  | Ok shape -> Ok shape
  | Error Empty ->
    refuse ~path Code.no_silhouette
      ~hint:
        "a pixel is of the shape when it is opaque, in a picture with transparency, and otherwise when it is far \
         from white; --background tells another colour"
      "nothing is drawn here: no pixel differs from the background"
  | Error (Several pieces) ->
    refuse ~path Code.several_pieces
      ~hint:
        "--piece 1 takes the largest one; pixels that only touch at a corner do not hang together"
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

let make ~progress ~path o picture =
  let* shape = silhouette ~path o picture in
  let* strength, greatest = strengths ~path o shape in
  let diffusion = Diffusion.solve ~progress:(progress "inflating") shape ~strength ~greatest in
  match Relief.make o.profile shape diffusion ~greatest with
  | None ->
    refuse ~path Code.cannot_inflate ~hint:"choose smaller strengths, and --scale to make all of it larger"
      "with these strengths it would be higher than %d pixels" Relief.most
  | Some relief -> (
      match Solid_of.make ~progress:(progress "simplifying") ~faces:o.faces ~scale:o.scale relief with
      | Ok solid -> Ok { relief; solid }
      | Error needed ->
        refuse ~path Code.cannot_inflate
          ~hint:(Printf.sprintf "allow more, at least --faces %d, or all of them: --faces all" needed)
          "the drawing cannot be had with so few faces")
