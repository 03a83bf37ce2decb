(* The typed trees that the compiler left below a folder of the build. *)

(* Temporary files of a compiler that runs meanwhile may vanish. *)
let is_folder path = match Sys.is_directory path with is -> is | exception Sys_error _ -> false

let rec files folder =
  let inside name = Filename.concat folder name in
  List.concat_map
    (fun name ->
       if List.mem (Filename.extension name) [ ".cmt"; ".cmti" ] then [ inside name ]
       else if is_folder (inside name) then files (inside name)
       else [])
    (List.sort compare (Array.to_list (Sys.readdir folder)))

let read folder = List.map Cmt_format.read_cmt (files folder)

let visit (i : Tast_iterator.iterator) (cmt : Cmt_format.cmt_infos) =
  match cmt.cmt_annots with
  | Implementation s -> i.structure i s
  | Interface s -> i.signature i s
  | _ -> ()

(* The name of a module without that of its library. *)
let module_of (cmt : Cmt_format.cmt_infos) =
  match List.rev (Str.split (Str.regexp "__") cmt.cmt_modname) with
  | last :: _ -> last
  | [] -> cmt.cmt_modname
