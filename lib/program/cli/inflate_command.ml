open Scc_base
open Scc_exact
open Scc_verdicts
open Scc_inflate
open Cmdliner

type options = {
  path : string;
  resolution : int option;
  output : string option;
  each : bool;  (** one file for each piece *)
  inflate : Inflated.options;
}

(* {1 Report} *)

let profile_name = function Relief.Diffused -> "diffused" | Round -> "round"

(* A distance is told rounded up, so that what is said holds. *)
let short q = Decimal.significant ~digits:4 (Rat.short_above q)

let text o (t : Inflated.t) =
  let shape = t.relief.shape and gaps = t.solid.gaps in
  let height = Rat.make (Z.of_int t.relief.highest) (Z.of_int Relief.quanta) in
  let holes = match t.solid.holes with 0 -> "" | n -> Printf.sprintf ", with %s" (Plural.count n "hole" "holes") in
  let b = Buffer.create 256 in
  Printf.bprintf b "%s: %d x %d pixels, of which the shape has %d%s\n" (Visible.line o.path) shape.picture.width
    shape.picture.height shape.size holes;
  Printf.bprintf b "inflated: highest %s pixels (%s, radius %s)\n"
    (Decimal.significant ~digits:4 height)
    (profile_name o.inflate.profile)
    (Decimal.significant ~digits:4 t.relief.radius);
  Printf.bprintf b "  no height is farther than %s pixels from that of the exact solution\n" (short gaps.solution);
  if List.compare_length_with t.solids 1 > 0 then Printf.bprintf b "pieces: %d\n" (List.length t.solids);
  Printf.bprintf b "solid: %s, %s\n"
    (Printf.sprintf "%d vertices" (Array.length t.solid.mesh.ifs_vertices))
    (Plural.count (Array.length t.solid.mesh.ifs_faces) "face" "faces");
  if Rat.sign gaps.surface > 0 || Rat.sign gaps.outline > 0 then
    Printf.bprintf b "  simplified: heights change by at most %s pixels, the outline by at most %s\n"
      (short gaps.surface) (short gaps.outline);
  Buffer.contents b

type answer = options * Inflated.t * Console.t

let format : (answer, unit) Scc_json.Json_format.t =
  let open Scc_json.Json_format in
  let open Scc_runs in
  let shape (t : Inflated.t) = t.relief.shape and mesh (t : Inflated.t) = t.solid.mesh in
  let highest (t : Inflated.t) = Rat.make (Z.of_int t.relief.highest) (Z.of_int Relief.quanta) in
  let solid members = within (fun (_, t, _) -> t) (all members) in
  let option members = within (fun (o, _, _) -> o) (all members) in
  let distances =
    fields
      [
        field "solution" Shared.rational (fun (t : Inflated.t) -> t.solid.gaps.solution);
        field "surface" Shared.rational (fun (t : Inflated.t) -> t.solid.gaps.surface);
        field "outline" Shared.rational (fun (t : Inflated.t) -> t.solid.gaps.outline);
      ]
  in
  fields
    (Shared.head "scc-inflate" 1
     @ [
       field "exit" (one_of [ 0 ]) (fun _ -> Exit_code.(to_int Holds));
       option [ field "picture" text (fun o -> o.path) ~about:"Its file." ];
       solid
         [
           field "width" Shared.from_one (fun t -> (shape t).picture.width) ~about:"Of the picture, in pixels.";
           field "height" Shared.from_one (fun t -> (shape t).picture.height);
           field "pixels" Shared.from_one (fun t -> (shape t).size) ~about:"How many the shape has.";
           field "holes" natural (fun (t : Inflated.t) -> t.solid.holes);
           field "pieces" Shared.from_one (fun (t : Inflated.t) -> List.length t.solids)
             ~about:"How many closed surfaces the solid has.";
         ];
       option [ field "profile" (word profile_name [ Diffused; Round ]) (fun o -> o.inflate.profile) ];
       solid
         [
           field "radius" Shared.rational (fun (t : Inflated.t) -> t.relief.radius)
             ~about:"In pixels: over it heights are taken.";
           field "highest" Shared.rational highest ~about:"In pixels, before the solid is simplified.";
         ];
       option [ field "scale" Shared.rational (fun o -> o.inflate.scale) ~about:"The length of a pixel." ];
       solid
         [
           field "vertices" (integer ~least:5 ()) (fun t -> Array.length (mesh t).ifs_vertices);
           field "faces" (integer ~least:6 ()) (fun t -> Array.length (mesh t).ifs_faces);
           field "distances" distances Fun.id
             ~about:
               "In pixels, each of them proved: of heights from the exact solution, of the simplified heights \
                from those before, of the simplified outline from that before.";
         ];
       option [ field "output" (nullable text) (fun o -> o.output) ~about:"The file that was written, if any." ];
       field "diagnostics" Diag_json.formats (fun (_, _, console) ->
           (Console.source console, Console.kept console));
     ])

(* {1 Work} *)

(* The name of the file of a piece: bean-2.obj. *)
let numbered path k =
  let ending = Filename.extension path in
  Printf.sprintf "%s-%d%s" (Filename.remove_extension path) (k + 1) ending

let write_solids o write (found : Inflated.t) =
  let hint = ".off, .obj and .sc keep fractions" in
  let mesh (s : Solid_of.t) = s.mesh in
  let numbered path =
    let one k s =
      let path = numbered path k in
      ((path, write path), mesh s)
    in
    List.mapi one found.solids
  in
  let several = List.compare_length_with found.solids 1 > 0 in
  match o.output with
  | None -> Ok ()
  | Some path when o.each ->
    (* Each is an output of its own. *)
    let one solid = Written_solid.drawn ~hint [ solid ] in
    (match List.concat_map (fun s -> Result.fold ~ok:(fun () -> []) ~error:Fun.id (one s)) (numbered path) with
     | [] -> Ok ()
     | faults -> Error faults)
  | Some path when several && Filename.check_suffix (String.lowercase_ascii path) ".sc" ->
    Written_solid.templates ~hint path (numbered path)
  | Some path -> Written_solid.drawn ~hint [ ((path, write path), mesh found.solid) ]

let work console o () =
  let* source = Result.listed (Input.read console o.path) in
  if Scc_pixels.Icon.is_text (Source.text source) then Console.add_source console source;
  let read = Scc_pixels.Icon.read_warned ?resolution:o.resolution ~path:o.path in
  let* picture, warnings = Result.listed (read (Source.text source)) in
  Console.report console warnings;
  let progress what share =
    Console.progress console (Printf.sprintf "%s: %.0f %%" what (100. *. Float.min 1. share))
  in
  Result.listed (Inflated.make ~progress ~path:o.path o.inflate picture)

let declare_pieces console o (found : Inflated.t) =
  let piece path k _ = Outputs.file "a piece of -o" (Some (numbered path k)) in
  match o.output with
  | Some path when o.each -> Console.declare console (List.concat (List.mapi (piece path) found.solids))
  | Some _ | None -> ()

let report console o write found =
  declare_pieces console o found;
  let write () = match write with None -> Ok () | Some find -> write_solids o find found in
  let json () = Scc_json.Json_format.write format (o, found, console) in
  let* () = Console.answer_and_write console ~text:(fun () -> text o found) ~json write in
  Ok Exit_code.Holds

let run color json o bounds =
  let console = Console.make ~color ~json () in
  let inflate write = Bounded.within console bounds (work console o) (report console o write) in
  let outputs = Outputs.file "-o" o.output in
  let go write = Guard.run ~outputs console (fun () -> inflate write) in
  match o.output with
  | None -> go None
  | Some path ->
    let find path = Scc_mesh.Written.to_file ~path in
    let write path = Option.get (find path) in
    Guard.by_ending path ~endings:Scc_mesh.Written.endings ~what:"shapes" find (fun _ -> go (Some write))

(* {1 The command line} *)

let hexadecimal c = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')

let parse_colour s =
  let rec all i = i > 6 || (hexadecimal s.[i] && all (i + 1)) in
  if String.length s = 7 && s.[0] = '#' && all 1
  then Ok (int_of_string ("0x" ^ String.sub s 1 6))
  else Error (`Msg (Printf.sprintf "`%s' is no colour such as #ff8000" s))

let colour =
  let print ppf c = Format.pp_print_string ppf (Scc_pixels.Raster.colour_text c) in
  Arg.conv ~docv:"COLOUR" (parse_colour, print)

let strength_conv =
  let number s = Arg.conv_parser (Options.not_negative "strength") s in
  let parse s =
    match String.index_opt s '=' with
    | None -> Result.map (fun q -> (None, q)) (number s)
    | Some i ->
      Result.bind (parse_colour (String.sub s 0 i)) (fun c ->
          Result.map (fun q -> (Some c, q)) (number (String.sub s (i + 1) (String.length s - i - 1))))
  in
  let print ppf (c, q) =
    let colour = match c with None -> "" | Some c -> Scc_pixels.Raster.colour_text c ^ "=" in
    Format.fprintf ppf "%s%s" colour (Rat.to_string q)
  in
  Arg.conv ~docv:"STRENGTH" (parse, print)

let strengths =
  Options.repeated strength_conv [ "strength" ] ~docv:"STRENGTH"
    "The strength of the inflation: a number, 1 by default, or $(i,COLOUR)$(b,=)$(i,NUMBER), as in \
     $(b,'#ff0000=2'), for the pixels of exactly that colour. Repeatable, with one for each colour. A region \
     with 0 is a skin over its surroundings."

let strengths =
  let split given =
    let all = List.filter_map (fun (c, q) -> if c = None then Some q else None) given in
    let colours = List.filter_map (fun (c, q) -> Option.map (fun c -> (c, q)) c) given in
    let distinct = List.sort_uniq Int.compare (List.map fst colours) in
    if List.length all > 1 || List.length distinct < List.length colours then
      Error "--strength is given twice for the same pixels"
    else Ok ((match all with [ q ] -> q | _ -> Rat.one), colours)
  in
  Term.(term_result' ~usage:true (const split $ strengths))

let shaded =
  Options.flag [ "shaded" ]
    "Multiplies strengths by how dark a pixel is: the full strength for black, none for white, and in between by \
     the mean of red, green and blue."

let profile =
  let doc =
    "The height as a function of the fixed point v of diffusion (a paraboloid, over a disc). $(b,diffused), as \
     in Repenning's icons, is v/r with r the radius of about the largest disc in the shape. $(b,round) is the \
     root of v, which makes a sphere of a disc and has steep sides."
  in
  let choices = [ ("diffused", Relief.Diffused); ("round", Relief.Round) ] in
  Arg.(value & opt (enum choices) Relief.Diffused & info [ "profile" ] ~docv:"PROFILE" ~doc)

let faces =
  let least = 6 and most = 20_000 and default = 200 in
  let doc =
    Printf.sprintf
      "Simplifies the solid to at most $(docv) triangles, from %d to %d; $(b,all) keeps all triangles of the \
       pixels. Without this option, a drawing that cannot be had with so few gets more. The report has the \
       distance of the simplified surface from these."
      least most
  in
  let parse = function
    | "all" -> Ok `All
    | s -> (
        match int_of_string_opt s with
        | Some n when n >= least && n <= most -> Ok (`Most n)
        | _ -> Error (`Msg (Printf.sprintf "`%s' is neither a number from %d to %d nor `all'" s least most)))
  in
  let print ppf = function
    | `All -> Format.pp_print_string ppf "all"
    | `Most n | `About n -> Format.pp_print_int ppf n
  in
  Arg.(value & opt (conv ~docv:"N" (parse, print)) (`About default) & info [ "faces" ] ~docv:"N" ~doc)

let scale =
  Options.default (Options.positive "length") Rat.one [ "scale" ] ~docv:"LENGTH"
    "The length of a pixel in the solid, 1 by default."

let background =
  Options.maybe colour [ "background" ] ~docv:"COLOUR"
    "The colour of the background, as #ff8000. By default, the shape is the opaque part of a picture with \
     transparent pixels, and in other pictures the part that is far from white."

let piece =
  Options.maybe (Options.integer ~least:1 "number of a piece") [ "piece" ] ~docv:"N"
    "Takes this piece of a drawing in several pieces: 1 is the largest. Pixels are connected by their edges."

(* What becomes of several pieces, and if each has a file of its own. *)
let pieces =
  let doc =
    "What becomes of a drawing in several pieces. $(b,one): they are refused, unless $(b,--piece) takes one of \
     them. $(b,apart): all of them, in one file: several closed surfaces, or in .sc a template for each. \
     $(b,each): the same, with a file for each piece, as bean-1.obj, bean-2.obj, the largest first. $(b,plate): \
     all of them on a plate that holds them together, as one solid. It reaches two pixels beyond them. Its height \
     over the middle plane is a pixel, or as $(b,plate=)$(i,HEIGHT) says, in pixels."
  in
  let plate q = Ok (Inflated.Plate q, false) in
  let parse s =
    match String.index_opt s '=' with
    | Some i when String.sub s 0 i = "plate" ->
      let height = String.sub s (i + 1) (String.length s - i - 1) in
      Result.bind (Arg.conv_parser (Options.positive "height") height) plate
    | _ -> (
        match s with
        | "one" -> Ok (Inflated.Only None, false)
        | "apart" -> Ok (Apart, false)
        | "each" -> Ok (Apart, true)
        | "plate" -> plate Rat.one
        | _ -> Error (`Msg (Printf.sprintf "`%s' is none of one, apart, each, plate and plate=HEIGHT" s)))
  in
  let print ppf = function
    | Inflated.Only _, _ -> Format.pp_print_string ppf "one"
    | Apart, each -> Format.pp_print_string ppf (if each then "each" else "apart")
    | Plate q, _ -> Format.fprintf ppf "plate=%s" (Rat.to_string q)
  in
  let pieces = Arg.conv ~docv:"PIECES" (parse, print) in
  let given = Arg.(value & opt pieces (Inflated.Only None, false) & info [ "pieces" ] ~docv:"PIECES" ~doc) in
  let chosen piece ((pieces, _) as given) =
    match (piece, pieces) with
    | None, _ -> Ok given
    | Some _, Inflated.Only _ -> Ok (Only piece, false)
    | Some _, _ -> Error "--piece takes one piece, and --pieces all of them: give one of the two"
  in
  Term.(term_result' ~usage:true (const chosen $ piece $ given))

let resolution =
  let doc =
    Printf.sprintf "The number of pixels of the longer side of an SVG drawing, %d by default."
      Scc_pixels.Icon.default_resolution
  in
  let most = Scc_pixels.Raster.max_side in
  let pixels = Options.integer ~least:1 ~most (Printf.sprintf "number of pixels from 1 to %d" most) in
  Arg.(value & opt (some pixels) None & info [ "resolution" ] ~docv:"N" ~doc)

let output =
  let doc =
    Printf.sprintf "Writes the solid to $(docv), exactly. The ending of the name selects the format: %s."
      (String.concat ", " (List.map (fun e -> "$(b," ^ e ^ ")") Scc_mesh.Written.endings))
  in
  Arg.(value & opt (some Options.named) None & info [ "o"; "output" ] ~docv:"OUT" ~doc)

let icon =
  Options.argument 0 ~docv:"ICON"
    "The drawing: PNG, Netpbm (PBM, PGM, PPM) or SVG; $(b,-) reads it from standard input."

let options =
  let make path resolution output background (pieces, each) (strength, colours) shaded profile faces scale =
    let inflate = { Inflated.background; pieces; strength; colours; shaded; profile; faces; scale } in
    { path; resolution; output; each; inflate }
  in
  Term.(
    const make $ icon $ resolution $ output $ background $ pieces $ strengths $ shaded $ profile $ faces $ scale)

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:
        [
          (Holds, "if there is a solid."); (Invalid, "if the drawing cannot be read or inflated.");
          (Stopped, Bounded.exit);
        ]
  in
  Cmd.v
    (Cmd.info "inflate" ~doc:"make a solid of a drawn silhouette" ~man:Manual.inflate ~exits)
    Term.(const run $ Options.color $ Options.json $ options $ Bounded.term)
