; What declares names for a piece of a text, and for all of it.
(source_file) @local.scope
(for_declaration) @local.scope
(shape_declaration) @local.scope
(compound_declaration) @local.scope
(behaviour_declaration) @local.scope
(quantified) @local.scope
(count) @local.scope
(kick) @local.scope

(param_declaration name: (name) @local.definition.constant)
(let_declaration name: (name) @local.definition.constant)
(definition name: (name) @local.definition.constant)
(shape_declaration name: (name) @local.definition.type)
(compound_declaration name: (name) @local.definition.type)
(behaviour_declaration name: (name) @local.definition.function)
(process_declaration name: (name) @local.definition.var)
(fixed_declaration name: (name) @local.definition.var)
(range name: (name) @local.definition.var)
(quantified name: (name) @local.definition.var)
(count name: (name) @local.definition.var)
(parameters (name) @local.definition.parameter)

(path (name) @local.reference)
(template_name (name) @local.reference)
(behaviour_name (name) @local.reference)
