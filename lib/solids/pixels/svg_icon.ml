open Scc_base
open Scc_exact
open Svg_number
open Svg_scene
open Svg_clip

(* An XML file, with white space before it or not. *)
let is text =
  let blank c = List.mem c [ ' '; '\t'; '\n'; '\r' ] in
  let rec first i = if i < String.length text && blank text.[i] then first (i + 1) else i in
  let i = first (Source.after_mark text) in
  i < String.length text && text.[i] = '<'

exception Refused of Diag.t

(* {1 The picture} *)

(* The sides of the whole drawing; none if one is not given, or as a share of what is around it. Browsers then take
   the proportions of the viewBox. Sides in one unit have proportions even if the unit depends on a font. *)
let sides root =
  let side name =
    match Option.map String.trim (Svg_tree.attribute root name) with
    | None | Some "auto" -> None
    | Some text -> ( match with_unit text with _, "%" -> None | q, unit -> Some (q, unit, text))
  in
  match (side "width", side "height") with
  | Some (w, unit, _), Some (h, unit', _) when String.equal unit unit' -> Some (w, h)
  | Some (_, _, w), Some (_, _, h) -> Some (length w, length h)
  | None, _ | _, None -> None

(* The viewBox, and what is seen: more than it one way if the sides have other proportions. *)
let seen root =
  let ratio = Svg_tree.attribute root "preserveAspectRatio" in
  let whole width height = { Aspect.x = Rat.zero; y = Rat.zero; width; height } in
  match Option.map Aspect.box (Svg_tree.attribute root "viewBox") with
  | Some box -> (
      let positive = List.for_all (fun q -> Rat.sign q > 0) in
      match sides root with
      | Some (width, height) when positive [ width; height; box.width; box.height ] ->
        (box, Aspect.unfit ratio ~inside:(whole width height) box)
      | Some _ | None -> (box, box))
  | None -> (
      let given name = Option.map length (Svg_tree.attribute root name) in
      match (given "width", given "height") with
      | Some width, Some height -> (whole width height, whole width height)
      | _ -> raise (Bad "a drawing without a viewBox has to have a width and a height"))

(* What is less than half of a pixel more than the viewBox comes from sides that are rounded. *)
let close ~resolution (view : Aspect.box) (box : Aspect.box) =
  let more = Rat.add (Rat.sub box.width view.width) (Rat.sub box.height view.height) in
  Rat.compare (Rat.mul (Rat.of_int (2 * resolution)) more) (Rat.max view.width view.height) < 0

(* Its size in pixels, the map to them, and the viewport in units of the drawing. *)
let frame ~resolution ~path root =
  let view, box = seen root in
  let box = if close ~resolution view box then view else box in
  if Rat.sign box.width <= 0 || Rat.sign box.height <= 0 then raise (Bad "the drawing has no size");
  let scale = Rat.div (Rat.of_int resolution) (Rat.max box.width box.height) in
  let pixels q = max 1 (Z.to_int (Z.neg (Rat.floor (Rat.neg (Rat.mul scale q))))) in
  let width = pixels box.width and height = pixels box.height in
  match Picture_fault.check_size ~cure:"give `--resolution 512`, or less" ~path ~width ~height () with
  | Error d -> raise (Refused d)
  | Ok () ->
    let to_pixels = Plane_map.(compose (scaling scale scale) (translation (Rat.neg box.x) (Rat.neg box.y))) in
    (Raster.create ~width ~height, to_pixels, { Svg_shape.width = view.width; height = view.height })

(* {1 Elements} *)

(* What [draw] paints is one layer, as opaque as the element says. *)
let layered scene here draw =
  let opacity = here.style.own.opacity in
  if Rat.compare opacity Rat.one >= 0 then draw ()
  else begin
    let outer = scene.layer in
    let inner = Svg_layer.above outer in
    scene.layer <- inner;
    draw ();
    scene.layer <- outer;
    Svg_layer.put ~cost:(look scene) inner ~onto:outer opacity
  end

let paint scene here node =
  let s = here.style and budget = scene.corners in
  let outline = Svg_shape.outline here.view node in
  let gradient id =
    match Hashtbl.find_opt scene.tree.ids id with
    | Some ({ name = "linearGradient" | "radialGradient"; _ } as gradient) ->
      let box () = Svg_box.user_space scene here node ~size:node in
      let found = Svg_gradient.opacity scene.tree ~style:(style_at scene) ~view:here.view ~box gradient in
      (match found with
       | Between (low, high) when Rat.compare low high < 0 -> scene.fading <- Some (scene.at, id)
       | Between _ | Unseen | Ignored -> ());
      Some found
    | Some { name = "pattern"; _ } -> raise (Unread "patterns")
    | _ -> None
  in
  let put colour rule polygons =
    let painter = Svg_layer.painter ~cost:(look scene) scene.layer colour in
    inside scene rule polygons (fun k -> if within here.clip k then painter k)
  in
  let fill () =
    if node.name <> "line" then
      Option.iter
        (fun colour -> put colour s.rule (Svg_polygon.filled ~budget here.map outline))
        (Svg_style.painted s s.fill s.fill_opacity ~gradient)
  in
  let stroke () =
    match Svg_style.painted s s.stroke s.stroke_opacity ~gradient with
    | None -> ()
    | Some colour ->
      let put pen = put colour Fill.Nonzero (Svg_stroke.triangles ~budget here.map pen outline) in
      let pen = Svg_style.stroke s ~length:(Svg_shape.along here.view) in
      if pen <> None && s.dashes <> [] && Svg_tree.attribute node "pathLength" <> None then
        raise (Unread "pathLength with dashes");
      Option.iter put pen
  in
  if s.displayed && s.shown then begin
    if s.markers <> (false, false, false) then raise (Unread "markers");
    layered scene here (fun () -> if s.stroke_first then (stroke (); fill ()) else (fill (); stroke ()))
  end

(* What is around the content of a viewport at a rectangle, if something can be seen of it. *)
let viewport scene here node (inside : Aspect.box) =
  let clip () =
    if not here.style.own.clipped then here.clip
    else begin
      let found = mask scene in
      Svg_path.rectangle (inside.x, inside.y) (inside.width, inside.height) (Rat.zero, Rat.zero)
      |> Svg_polygon.filled ~budget:scene.corners here.map
      |> add scene found here.clip Fill.Nonzero;
      Some found
    end
  in
  Option.map (fun inner -> { inner with clip = clip () }) (fitted here node inside)

let refuse name cure = raise (Unread (Printf.sprintf "the element %S: %s" name cure))

(* What is in a shape is to change nothing of it. *)
let check_content scene (node : Svg_tree.node) =
  let refused (inner : Svg_tree.node) =
    scene.at <- inner.at;
    let cure =
      match Svg_table.element inner.name with
      | Refused cure -> cure
      | Group | Shape | Use | Viewport | Silent -> "it does not belong into a shape"
    in
    refuse inner.name cure
  in
  List.iter refused node.children

(* A text without any letter draws nothing; programs leave such ones behind. *)
let rec is_empty_text (node : Svg_tree.node) =
  List.mem node.name [ "text"; "tspan" ]
  && List.for_all (String.for_all is_blank) node.text
  && List.for_all is_empty_text node.children

let rec element scene around (node : Svg_tree.node) =
  match Svg_table.element node.name with
  | Silent -> ()
  | Group ->
    let here = clipped scene (enter scene around node) node in
    layered scene here (fun () -> children scene here node)
  | Shape ->
    paint scene (clipped scene (enter scene around node) node) node;
    check_content scene node
  | Viewport -> shown_at scene around node ~size:node
  | Use -> (
      let here = clipped scene (enter scene around node) node in
      match used scene here node with
      | None -> ()
      | Some (inner, target) ->
        layered scene here (fun () ->
            match target.name with
            | "symbol" | "svg" -> shown_at scene inner target ~size:node
            | _ -> element scene inner target))
  | Refused _ when node.name = "text" && is_empty_text node -> ()
  | Refused cure ->
    scene.at <- node.at;
    refuse node.name cure

and children scene here (node : Svg_tree.node) = if here.style.displayed then List.iter (element scene here)
      (Svg_switch.children node)

(* A drawing within the drawing; [size] is the element whose width and height count most. *)
and shown_at scene around node ~size =
  let here = clipped ~size scene (enter scene around node) node in
  let draw inner = layered scene here (fun () -> children scene inner node) in
  Option.iter draw (viewport scene here node (rectangle here node ~size))

(* How the view box is fitted into the drawing changes its shape only if it is stretched or cut. *)
let check_ratio root =
  match Svg_tree.attribute root "preserveAspectRatio" with
  | None -> ()
  | Some text ->
    let words = String.split_on_char ' ' (String.trim text) in
    if List.mem "none" words || List.mem "slice" words then
      raise (Unread (Printf.sprintf "preserveAspectRatio %S of the whole drawing" text))

(* The layer as the picture. *)
let finish scene =
  let pixel k =
    match Svg_layer.seen scene.layer k with
    | Transparent -> ()
    | Seen colour ->
      scene.raster.colours.(k) <- colour;
      Bytes.set_uint8 scene.raster.alphas k 255
    | Open ->
      let id = match scene.fading with Some (at, id) -> scene.at <- at; id | None -> "" in
      raise (Unread (Printf.sprintf "the gradient %S: its stops are on both sides of half opaque" id))
  in
  for k = 0 to Bytes.length scene.raster.alphas - 1 do pixel k done

let draw ~resolution ~path tree =
  let root = tree.Svg_tree.root in
  Svg_tree.iter (fun node -> Svg_tree.at node (fun () -> Svg_value.check node)) root;
  let raster, map, view =
    Svg_tree.at root (fun () ->
        check_ratio root;
        frame ~resolution ~path root)
  in
  let layer = Svg_layer.whole (Bytes.length raster.alphas) in
  let corners = ref Svg_polygon.max_corners in
  let scene = { tree; raster; corners; layer; fading = None; blended = None; drawn = 0; area = 0; at = root.at } in
  let around = { style = Svg_style.initial; map = Plane_map.identity; clip = None; view; depth = 0; used = [] } in
  match
    let here = enter scene around root in
    if not (Plane_map.is_identity here.map) then
      raise (Unread "a transform of the whole drawing: put a `g` into it");
    let here = clipped scene { here with map } root in
    layered scene here (fun () -> children scene here root);
    finish scene
  with
  | () -> (raster, scene.blended)
  | exception ((Bad _ | Unread _ | Beyond _) as fault) -> raise (Svg_tree.Fault (scene.at, fault))

(* {1 Faults} *)

(* The byte at a line and column of characters, both from 1. *)
let offset text (line, column) =
  let n = String.length text in
  let rec start i line =
    if line <= 1 then i
    else match String.index_from_opt text i '\n' with Some j -> start (j + 1) (line - 1) | None -> n
  in
  let rec along i column =
    if column <= 1 || i >= n then min i n
    else
      let rec next j = if j < n && Char.code text.[j] land 0xc0 = 0x80 then next (j + 1) else j in
      along (next (i + 1)) (column - 1)
  in
  if n = 0 then 0 else along (start 0 line) column

(* The tag at whose name, or just after it, a place is: its start with its name. *)
let tag text at =
  match String.rindex_from_opt text (min (offset text at) (String.length text - 1)) '<' with
  | None -> (0, 0)
  | Some start ->
    let in_name i = i < String.length text && not (is_blank text.[i] || text.[i] = '>' || text.[i] = '/') in
    let rec stop i = if in_name i then stop (i + 1) else i in
    (start, stop (start + 1))

let read ~resolution ~path text =
  let fault_at code ?hint (start, stop) message =
    Error (Diag.error ?hint code (Span.make ~file:path ~start ~stop) "%s" message)
  in
  let fault code ?hint at message = fault_at code ?hint (tag text at) message in
  let warning what at =
    let start, stop = tag text at in
    Diag.warning Code.mesh_left_out (Span.make ~file:path ~start ~stop) "%s" what
  in
  let work () =
    let tree = Svg_tree.read ~valid:Svg_style.is_valid text in
    (tree, draw ~resolution ~path tree)
  in
  match work () with
  | tree, (raster, blended) ->
    let told what at = Option.to_list (Option.map (warning what) at) in
    let programs = told "programs in the drawing are not run: what they would change is left out" tree.program in
    let mixed = "colours are not mixed with those below: they may differ from what browsers show" in
    Ok (raster, programs @ told mixed blended)
  | exception Refused d -> Error d
  | exception Xmlm.Error (at, error) ->
    let at = offset text at in
    fault_at Code.bad_picture (at, at) ("the XML is not well formed: " ^ Xmlm.error_message error)
  | exception Svg_tree.Fault (at, Unread what) ->
    fault Code.picture_format at ("this is not read: " ^ what)
      ~hint:"shapes with fills and strokes are read, in groups and where they are used, with transforms and clip \
             paths"
  | exception Svg_tree.Fault (at, Beyond what) ->
    fault Code.bad_picture at ("the drawing is beyond a limit: it has more than " ^ what)
      ~hint:"a smaller `--resolution` helps where outlines are fine, and otherwise a drawing in parts, or with \
             fewer points and dashes"
  | exception Svg_tree.Fault (at, Bad what) -> fault Code.bad_picture at ("a fault in the drawing: " ^ what)
